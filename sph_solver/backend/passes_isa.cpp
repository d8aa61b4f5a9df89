// The neighbour loops, compiled once per instruction set (TW_ISA names it). Nothing here may call inline functions of
// the standard library: the linker would be free to keep this file's AVX-512 copy for the whole program.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/equations/artificial_viscosity.h"
#include "sph_solver/equations/continuity.h"
#include "sph_solver/equations/density_diffusion.h"
#include "sph_solver/equations/edge_release.h"
#include "sph_solver/equations/pressure_gradient.h"
#include "sph_solver/equations/renormalisation.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/equations/wall_pressure.h"
#include "sph_solver/equations/wall_touch.h"

namespace tw {
namespace TW_ISA {
namespace {

/// First sweep of a step: velocity divergence (continuity), and with it what the second sweep needs of the
/// neighbourhood: renormalised density gradient, kernel support and the shifting sum.
template <bool walls_move>
void sweep_continuity_and_gradient(const PassData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const Shifting shifting(d.kernel, d.inv_W_dp);
    const WallTouch wall_touch{d.kernel.support_length * d.inv_dp, d.inv_void};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        const Real drho_i = own(g, [&](int i) { return d.motion[i].drho; });
        Real divergence{}, wall_divergence{}, support{}, difference2{};
        V3<Real> shift{};
        ScalarGradient<Real> grad_rho;
        for_each_neighbour(d.place, d.list, g.list, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& r_j = d.motion[j];
            support += ij.V_W();
            shifting.add(ij, shift);
            const V3<Real> u_ij = u_i - velocity(r_j);
            Shifting::add_difference(ij, u_ij, difference2);
            Continuity::add(ij, u_ij, divergence);
            grad_rho.add(ij, r_j.drho - drho_i);
        });
        V3<Real> n_i{};
        for (int l = 0; l < lanes && g.wall_list.size > 0; ++l) {
            const WallNormalRecord& r = d.normal[in_lane(g, l)];
            n_i.x[l] = r.x, n_i.y[l] = r.y, n_i.z[l] = r.z;
        }
        const Real u_n = dot(u_i, n_i);
        const V3<Real> u_slip = slip_velocity(u_n, n_i);
        Real touch{};
        if (g.wall_list.size > 0)
            for_each_neighbour(d.place, d.list, g.list, g, frame, x_i,
                               [&](std::int32_t, const Met& ij) { wall_touch.add(ij, n_i, touch); });
        for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            support += ij.V_W();
            shifting.add(ij, shift);
            wall_touch.add(ij, n_i, touch);
            if constexpr (walls_move) {
                const WallVelocity& u_j = d.wall_velocity[j];
                Continuity::add(ij, slip_velocity(u_n - dot(V3<float>{u_j.u, u_j.v, u_j.w}, n_i), n_i),
                                wall_divergence);
            } else {
                Continuity::add(ij, u_slip, wall_divergence);
            }
        });
        support *= d.kernel.W_over_G, difference2 *= d.kernel.W_over_G;
        if (d.other)
            for (int l = 0; l < g.size; ++l) {
                const OtherSums& other = d.other[g.first + l];
                support[l] += other.support, divergence[l] += other.divergence;
                difference2[l] += other.difference2;
                shift.x[l] += other.x, shift.y[l] += other.y, shift.z[l] += other.z;
            }
        if (g.wall_list.size > 0) {
            touch *= d.kernel.W_over_G;
            for (int l = 0; d.other && l < g.size; ++l) touch[l] += 2.0f * d.other[g.first + l].support;
            divergence += wall_touch.compression(wall_divergence, touch);
        }
        FirstMoment<Real>& moment = grad_rho.moment;
        moment.scale(d.kernel.support_length);
        if (d.carried)
            for (int l = 0; l < g.size; ++l)
                d.carried[g.first + l] = {moment.xx[l], moment.xy[l], moment.xz[l],
                                          moment.yy[l], moment.yz[l], moment.zz[l]};
        if (d.two_dimensional) moment.fill_second_axis();
        const V3<Real> grad = moment.solve(grad_rho.sum);
        Real shift_speed = simd::min(Shifting::b * simd::root(difference2), Real{} + d.fastest_shift);
        // nothing else ties the number of those to their density: they would gather under the zone
        for (int l = 0; d.kind && l < g.size; ++l)
            if (d.kind[g.first + l] == Kind::carried) shift_speed[l] = d.fastest_shift;
        shift = shift_speed * shift;
        for (int l = 0; l < g.size; ++l) {
            GradientPressureRecord& out = d.stress[g.first + l];
            out.gx = grad.x[l], out.gy = grad.y[l], out.gz = grad.z[l];
            d.rate[g.first + l].drho = (d.rho0 + drho_i[l]) * divergence[l];
            d.shift[g.first + l] = {shift.x[l], shift.y[l], shift.z[l], support[l]};
        }
    }
}

void continuity_and_gradient(const PassData& d, const Group* groups, int count) {
    if (d.wall_velocity)
        sweep_continuity_and_gradient<true>(d, groups, count);
    else
        sweep_continuity_and_gradient<false>(d, groups, count);
}

/// Never inlined: which sums are fused with their products would depend on what stands before.
[[gnu::noinline]] void shift_along_surface(const V3<Real>& towards_surface, ShiftSupportRecord* shift, int size) {
    const Real N2 = dot(towards_surface, towards_surface);
    for (int l = 0; l < size; ++l) {
        V3<float> s{shift[l].x, shift[l].y, shift[l].z};
        keep_along_surface(in_lane(towards_surface, l), N2[l], s);
        shift[l].x = s.x, shift[l].y = s.y, shift[l].z = s.z;
    }
}

/// Of those of a group's particles that are beyond an edge and lack support.
inline EdgeRelease<Real> release_at_edges(const PassData& d, const Group& g) {
    EdgeRelease<Real> r{};
    if (g.wall_list.size == 0 || d.leaving == nullptr) return r;
    for (int l = 0; l < g.size; ++l) {
        const int i = g.first + l;
        const LeavingRecord& way = d.leaving[i];
        if (way.speed2 == 0 || (d.surface[i / 32] >> (i % 32) & 1) == 0) continue;
        r.e.x[l] = way.x, r.e.y[l] = way.y, r.e.z[l] = way.z;
        r.s[l] = released_share(d.stress[i].p, d.rho0, way.speed2);
    }
    return r;
}

/// Second sweep: pressure, artificial viscosity and density diffusion. Walls press, and do not rub (slip).
void forces(const PassData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const ArtificialViscosity<Math> artificial_viscosity{d.viscosity};
    const DensityDiffusion density_diffusion{0.5f * d.kernel.support_length};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        V3<Real> grad_i{};
        Real drho_i{}, p_i{}, V_i{};
        for (int l = 0; l < lanes; ++l) {
            const int i = in_lane(g, l);
            drho_i[l] = d.motion[i].drho;
            grad_i.x[l] = d.stress[i].gx, grad_i.y[l] = d.stress[i].gy, grad_i.z[l] = d.stress[i].gz;
            p_i[l] = d.stress[i].p;
            V_i[l] = d.place[i].volume;
        }
        control_tension(d, g, p_i);
        Real diffusion{};
        V3<Real> water{}, towards_surface{};
        for_each_neighbour(d.place, d.list, list_for_rates(d, g), g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& r_j = d.motion[j];
            const GradientPressureRecord& s_j = d.stress[j];
            density_diffusion.add(ij, r_j.drho - drho_i, grad_i + V3<float>{s_j.gx, s_j.gy, s_j.gz}, diffusion);
            PressureGradient::add(ij, p_i + s_j.p + artificial_viscosity.pressure(ij, u_i - velocity(r_j)), water);
        });
        for_each_neighbour(
            d.place, d.list, g.list, g, frame, x_i,
            [&](std::int32_t, const Met& ij) { towards_surface += ij.V_gradW(); }, AtSurface{d.surface});
        // The volume that the neighbours see, not this density's: so the forces of a pair cancel to rounding.
        const Real inv_rho = V_i * d.inv_mass;
        const Real drho = d.diffusion * diffusion;
        V3<Real> a_wall{};
        const EdgeRelease<Real> edge_release = release_at_edges(d, g);
        for_each_body(d, g, [&](const ListRef& part, std::int32_t slot, std::int32_t body) {
            V3<Real> wall{};
            for_each_neighbour(d.wall_place, d.wall_list, part, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
                PressureGradient::add(ij, p_i + d.wall_p[j], wall);
            });
            V3<Real> a_body = inv_rho * wall;
            edge_release.apply(a_body);
            a_wall += a_body;
            if (slot >= 0) d.wall_load[slot] = load_of(d, g, x_i, a_body, body);
        });
        const V3<Real> a{water.x * inv_rho + a_wall.x + d.gx, water.y * inv_rho + a_wall.y + d.gy,
                         water.z * inv_rho + a_wall.z + d.gz};
        for (int l = 0; l < g.size; ++l) d.rate[g.first + l] = {a.x[l], a.y[l], a.z[l], drho[l]};
        shift_along_surface(towards_surface, d.shift + g.first, g.size);
    }
}

/// Pressure at points from the fluid round them, see wall_pressure.h.
template <bool points_accelerate>
void extrapolate_to(const ExtrapolateData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const float to_m = d.kernel.support_length;
    const V3<float> g_2h = to_m * V3<float>{d.gx, d.gy, d.gz};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_d = own_places(d.at, g, frame);
        V3<Real> g_minus_a_2h{};
        for (int l = 0; l < lanes && points_accelerate; ++l) {
            const WallAcceleration& a = d.acceleration[in_lane(g, l)];
            g_minus_a_2h.x[l] = to_m * (d.gx - a.x);
            g_minus_a_2h.y[l] = to_m * (d.gy - a.y);
            g_minus_a_2h.z[l] = to_m * (d.gz - a.z);
        }
        Real support{}, p{};
        FirstMoment<Real> flux;
        for_each_neighbour(d.place, d.list, g.list, g, frame, x_d, [&](std::int32_t f, const Met& ij) {
            const Real V_W = ij.V_W();
            support += V_W;
            const float p_f = d.stress[f].p, rho_f = d.rho0 + d.motion[f].drho;
            Real carried;
            if constexpr (points_accelerate)
                carried = WallPressure::carried(ij, p_f, rho_f, g_minus_a_2h);
            else
                carried = WallPressure::carried(ij, p_f, rho_f, g_2h);
            const Real share = V_W * carried;
            p += share;
            if (d.flux) {
                const CarriedShare& m = d.carried[f];
                flux.xx += share * m.xx, flux.xy += share * m.xy, flux.xz += share * m.xz;
                flux.yy += share * m.yy, flux.yz += share * m.yz, flux.zz += share * m.zz;
            }
        });
        support *= d.kernel.W_over_G;
        p *= d.kernel.W_over_G;
        const Real inv = support > WallPressure::least_support ? 1.0f / support : Real{};
        for (int l = 0; l < g.size; ++l) {
            const int i = g.first + l;
            d.p[i] = p[l] * inv[l];
            if (d.support) d.support[i] = support[l];
            if (!d.flux) continue;
            const float of_point[6] = {flux.xx[l], flux.xy[l], flux.xz[l], flux.yy[l], flux.yz[l], flux.zz[l]};
            for (int k = 0; k < 6; ++k) d.flux[6 * i + k] = d.kernel.W_over_G * of_point[k];
        }
    }
}

void extrapolate(const ExtrapolateData& d, const Group* groups, int count) {
    if (d.acceleration)
        extrapolate_to<true>(d, groups, count);
    else
        extrapolate_to<false>(d, groups, count);
}

GroupReach reach_of(const PlaceRecord* places, const Group& g, const Reaches& reaches) {
    GroupReach r;
    for (int l = 0; l < lanes; ++l) {
        const PlaceRecord& p = places[in_lane(g, l)];
        const float x = static_cast<float>(difference(p.x, g.x)), y = static_cast<float>(difference(p.y, g.y)),
                    z = static_cast<float>(difference(p.z, g.z));
        r.n[l] = x * x + y * y + z * z;
        r.a[l] = -2 * x, r.b[l] = -2 * y, r.c[l] = -2 * z;
    }
    r.x = g.x, r.y = g.y, r.z = g.z;
    r.far2 = static_cast<float>(reaches.far * reaches.far) * 1.000002f;
    r.now2 = static_cast<float>(reaches.now * reaches.now) * 1.000002f;
    r.sure2 = static_cast<float>(reaches.sure > 0 ? reaches.sure * reaches.sure : 0);
    return r;
}

/// As many places as there are lanes, as three vectors.
typedef std::int32_t Ints __attribute__((vector_size(4 * lanes)));
typedef std::uint32_t Words __attribute__((vector_size(4 * lanes)));
struct Places {
    Ints x, y, z;
};
typedef std::int32_t I8 __attribute__((vector_size(32)));
struct Places8 {
    I8 x, y, z;
};
inline Places8 transposed(I4 r0, I4 r1, I4 r2, I4 r3, I4 r4, I4 r5, I4 r6, I4 r7) {
    const I8 a = __builtin_shufflevector(r0, r4, 0, 1, 2, 3, 4, 5, 6, 7),
             b = __builtin_shufflevector(r1, r5, 0, 1, 2, 3, 4, 5, 6, 7),
             c = __builtin_shufflevector(r2, r6, 0, 1, 2, 3, 4, 5, 6, 7),
             d = __builtin_shufflevector(r3, r7, 0, 1, 2, 3, 4, 5, 6, 7);
    const I8 ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
             cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
             ab_z = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
             cd_z = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab_z, cd_z, 0, 1, 8, 9, 4, 5, 12, 13)};
}
/// `record(k)`: the k-th of them.
template <class Record>
[[gnu::always_inline]] inline Places gathered(const Record& record) {
    const auto eight = [&](int k) {
        return transposed(record(k), record(k + 1), record(k + 2), record(k + 3), record(k + 4), record(k + 5),
                          record(k + 6), record(k + 7));
    };
    const Places8 low = eight(0);
#if TW_LANES == 8
    return {low.x, low.y, low.z};
#else
    const Places8 high = eight(8);
    const auto joined = [](const I8& a, const I8& b) {
        return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    };
    return {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
#endif
}

/// Squared distance of places from the nearest of the group's particles [quanta^2].
inline Real distance2(const GroupReach& g, const Places& q) {
    const auto from = [](const Ints& a, std::int32_t b) {
        return __builtin_convertvector((Ints)((Words)a - static_cast<std::uint32_t>(b)), Real);
    };
    const Real x = from(q.x, g.x), y = from(q.y, g.y), z = from(q.z, g.z);
    Real least = g.n[0] + g.a[0] * x + g.b[0] * y + g.c[0] * z;
    for (int l = 1; l < lanes; ++l) least = simd::min(least, g.n[l] + g.a[l] * x + g.b[l] * y + g.c[l] * z);
    return least + (x * x + y * y + z * z);
}

Reached reached(const GroupReach& g, const PlaceRecord* first, const PlaceRecord* end, int count, std::int64_t top) {
    Reached r{0, 0, 0};
    for (int k = 0; k < count && difference(first[k].z, g.z) <= top; k += lanes) {
        PlaceRecord last[lanes];
        const PlaceRecord* p = first + k;
        if (end - p < lanes) {
            for (int m = 0; m < lanes; ++m) last[m] = p + m < end ? p[m] : p[0];
            p = last;
        }
        const I4* v = reinterpret_cast<const I4*>(p);
        const Real d2 = distance2(g, gathered([&](int m) { return v[m]; }));
        r.far |= simd::bits_below(d2, g.far2) << k;
        r.now |= simd::bits_below(d2, g.now2) << k;
        r.sure |= simd::bits_below(d2, g.sure2) << k;
    }
    const std::uint32_t there = count < 32 ? (1u << count) - 1 : ~0u;
    return {r.far & there, r.now & there, r.sure & there};
}

/// Asks the doubtful places only, gathered from their blocks, and hands the answers back to the blocks' bits.
void prune(const PruneData& d, const Group* groups, int count) {
    constexpr int capacity = 256;
    std::int32_t index[capacity + 16];
    unsigned char within[capacity / 8 + 8];
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const ListRef& list = g.*d.list;
        if (list.size == 0) continue;
        const GroupReach own = reach_of(d.of, g, Reaches{0, d.reach, 0});
        const auto record = [&](int k) { return *reinterpret_cast<const I4*>(d.place + index[k]); };
        NeighbourBlock *block = d.lists.blocks(list), *const end = block + list.size;
        while (block != end) {
            NeighbourBlock* const first = block;
            int doubtful = 0;
            for (; block != end && doubtful <= capacity - 32; ++block)
                doubtful = simd::append_set_bits(block->first, block->maybe, index, doubtful);
            if (doubtful == 0) continue;
            for (int k = 0; k < lanes - 1; ++k) index[doubtful + k] = index[0];
            for (int k = 0; k < doubtful; k += lanes) {
                const Real d2 = distance2(own, gathered([&](int m) { return record(k + m); }));
                const std::uint32_t bits = simd::bits_below(d2, own.now2);
                __builtin_memcpy(within + k / 8, &bits, lanes / 8);
            }
            int at = 0;
            for (NeighbourBlock* b = first; b != block; ++b) {
                std::uint64_t answers;
                __builtin_memcpy(&answers, within + at / 8, 8);
                b->live = (b->live & ~b->maybe) |
                          simd::deposit_bits(static_cast<std::uint32_t>(answers >> (at % 8)), b->maybe);
                at += __builtin_popcount(b->maybe);
            }
        }
    }
}

}  // namespace

void water_velocity(const VelocityData&, const Group*, int);
void viscous_forces(const ViscousData&, const Group*, int);
void strain_rate(const StrainData&, const Group*, int);
void colour_gradient(const ColourData&, const Group*, int);
void surface_curvature(const ColourData&, const Group*, int);
void meet_other_phase(const LevelPairData&, const Group*, int);
void press_other_phase(const LevelPairData&, const Group*, int);
void interpolate(const InterpolateData&, const Group*, int);

extern const Passes table;
#ifdef TW_WITHOUT_EFFECTS
const Passes table = {
    TW_ISA_NAME, lanes, prune, continuity_and_gradient, forces, extrapolate, reach_of, reached, {}, {}, {}, {}, {},
    {},          {},    {}};
#else
const Passes table = {TW_ISA_NAME,
                      lanes,
                      prune,
                      continuity_and_gradient,
                      forces,
                      extrapolate,
                      reach_of,
                      reached,
                      water_velocity,
                      viscous_forces,
                      strain_rate,
                      colour_gradient,
                      surface_curvature,
                      meet_other_phase,
                      press_other_phase,
                      interpolate};
#endif

}  // namespace TW_ISA
}  // namespace tw
