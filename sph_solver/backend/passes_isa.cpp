// The neighbour loops, compiled once per instruction set (TW_ISA names it). Nothing here may call inline functions of
// the standard library: the linker would be free to keep this file's AVX-512 copy for the whole program.
#include "sph_solver/backend/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

/// First sweep of a step: velocity divergence (continuity), and with it what the second sweep needs of the
/// neighbourhood: renormalised density gradient (Randles & Libersky 1996), kernel support and the shifting sum (Sun et
/// al. 2017):
///   <grad rho>_i = L_i sum_j (rho_j - rho_i) grad W_ij V_j,   L_i^-1 = sum_j r_ji (x) grad W_ij V_j
/// Slip wall: the wall's velocity in the continuity sum is u_i - (u_i . n_i) n_i with the exterior normal n_i at the
/// fluid particle, so u_i - u_wall = (u_i . n_i) n_i.
void continuity_and_gradient(const PassData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const ShiftWeight weight(d);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        const V3<F> u = velocities(d, g);
        V3<F> n_i{F{}, F{}, F{}};
        F drho_i{};
        for (int l = 0; l < lanes; ++l) drho_i[l] = d.motion[g.first + (l < g.size ? l : g.size - 1)].drho;
        F m[6] = {}, divergence{}, wall_divergence{}, support{};
        V3<F> b{F{}, F{}, F{}}, s{F{}, F{}, F{}};
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            weight.count_in(ij, support, s);
            const V3<F>& r = ij.r_ji;
            const V3<F> f = ij.gradient();
            m[0] += f.x * r.x;
            m[1] += f.x * r.y;
            m[2] += f.x * r.z;
            m[3] += f.y * r.y;
            m[4] += f.y * r.z;
            m[5] += f.z * r.z;
            const VelocityDensityRecord& mj = d.motion[j];
            Continuity::add(f, V3<F>{u.x - mj.u, u.y - mj.v, u.z - mj.w}, divergence);
            const F jump = mj.drho - drho_i;
            b.x += jump * f.x;
            b.y += jump * f.y;
            b.z += jump * f.z;
        });
        for (int l = 0; l < lanes && g.wall_list.size > 0; ++l) {
            const WallNormalRecord& r = d.normal[g.first + (l < g.size ? l : g.size - 1)];
            n_i.x[l] = r.x;
            n_i.y[l] = r.y;
            n_i.z[l] = r.z;
        }
        const F u_n = dot(u, n_i);
        const V3<F> u_iw{u_n * n_i.x, u_n * n_i.y, u_n * n_i.z};
        for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, a, [&](std::int32_t, const Met& ij) {
            weight.count_in(ij, support, s);
            Continuity::add(ij.gradient(), u_iw, wall_divergence);
        });
        support *= d.kernel.tenth_h;
        if (d.other)
            for (int l = 0; l < g.size; ++l) {
                const OtherSums& other = d.other[g.first + l];
                support[l] += other.support, divergence[l] += other.divergence;
                s.x[l] += other.x, s.y[l] += other.y, s.z[l] += other.z;
            }
        for (F& entry : m) entry *= d.kernel.support_length;
        if (g.wall_list.size > 0) {
            // A wall compresses only the water that it touches: while the support is incomplete there is a void between
            // them, and the void closes first. Receding walls pull at once.
            const F void_share = simd::positive_part(1.0f - support) * d.inv_void;
            const F touch = simd::positive_part(1.0f - void_share);
            const F compression = simd::positive_part(wall_divergence);
            divergence += wall_divergence + compression * (touch - 1.0f);
        }
        if (d.carried)
            for (int l = 0; l < g.size; ++l)
                d.carried[g.first + l] = {m[0][l] * support[l], m[3][l] * support[l], m[5][l] * support[l]};
        if (d.two_dimensional) m[3] += 1.0f;
        const V3<F> grad = solve_symmetric(m, b);
        for (int l = 0; l < g.size; ++l) {
            GradientPressureRecord& out = d.stress[g.first + l];
            out.gx = grad.x[l];
            out.gy = grad.y[l];
            out.gz = grad.z[l];
            d.rate[g.first + l].drho = (d.rho0 + drho_i[l]) * divergence[l];
            d.shift[g.first + l] = {s.x[l], s.y[l], s.z[l], support[l]};
        }
    }
}

/// Shifting goes along the surface only: towards it, it would pump water up for ever.
///
/// Never inlined: which sums are fused with their products would depend on what stands before.
[[gnu::noinline]] void shift_along_surface(const V3<F>& towards_surface, ShiftSupportRecord* shift, int size) {
    const F normal2 = dot(towards_surface, towards_surface);
    for (int l = 0; l < size; ++l) {
        if (!(normal2[l] > 0)) continue;
        ShiftSupportRecord& s = shift[l];
        const float x = towards_surface.x[l], y = towards_surface.y[l], z = towards_surface.z[l];
        const float share = (s.x * x + s.y * y + s.z * z) / normal2[l];
        s.x -= share * x, s.y -= share * y, s.z -= share * z;
    }
}

/// Second sweep: pressure, artificial viscosity and density diffusion. Walls press, and do not rub (slip).
void forces(const PassData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const ArtificialViscosity artificial_viscosity{d.viscosity};
    const DensityDiffusion density_diffusion{0.5f * d.kernel.support_length};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        const V3<F> u = velocities(d, g);
        V3<F> grad{};
        F drho_i{}, p_i{}, V_i{};
        for (int l = 0; l < lanes; ++l) {
            const int i = g.first + (l < g.size ? l : g.size - 1);
            drho_i[l] = d.motion[i].drho;
            grad.x[l] = d.stress[i].gx;
            grad.y[l] = d.stress[i].gy;
            grad.z[l] = d.stress[i].gz;
            p_i[l] = d.stress[i].p;
            V_i[l] = d.place[i].volume;
        }
        control_tension(d, g, p_i);
        F diffusion{};
        V3<F> water{F{}, F{}, F{}}, wall{F{}, F{}, F{}}, towards_surface{F{}, F{}, F{}};
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& mj = d.motion[j];
            const GradientPressureRecord& sj = d.stress[j];
            const V3<F> u_ij{u.x - mj.u, u.y - mj.v, u.z - mj.w};
            density_diffusion.add(ij, mj.drho - drho_i, V3<F>{grad.x + sj.gx, grad.y + sj.gy, grad.z + sj.gz},
                                  diffusion);
            PressureGradient::add(ij, p_i + sj.p + artificial_viscosity.pressure(ij, u_ij), water);
        });
        for_each_neighbour(
            d.place, d.list, g.list, g, frame, a,
            [&](std::int32_t, const Met& ij) {
                const V3<F> f = ij.gradient();
                towards_surface.x += f.x, towards_surface.y += f.y, towards_surface.z += f.z;
            },
            AtSurface{d.surface});
        for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, a,
                           [&](std::int32_t j, const Met& ij) { PressureGradient::add(ij, p_i + d.wall_p[j], wall); });
        // The volume that the neighbours see, not this density's: so the forces of a pair cancel to rounding.
        const F inv_rho = V_i * d.inv_mass;
        const F drho = d.diffusion * diffusion;
        const V3<F> w{wall.x * inv_rho, wall.y * inv_rho, wall.z * inv_rho};
        const V3<F> acc{water.x * inv_rho + w.x + d.gx, water.y * inv_rho + w.y + d.gy, water.z * inv_rho + w.z + d.gz};
        for (int l = 0; l < g.size; ++l) d.rate[g.first + l] = {acc.x[l], acc.y[l], acc.z[l], drho[l]};
        shift_along_surface(towards_surface, d.shift + g.first, g.size);
        if (g.wall_load >= 0) d.wall_load[g.wall_load] = load_of(a, d.kernel.support_length, w, g.size);
    }
}

/// Fields at points from the fluid round them (Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005):
///   p_b = sum_f (p_f + rho_f g . (x_b - x_f)) V_f W_bf / sum_f V_f W_bf
void extrapolate(const ExtrapolateData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const float to_m = d.kernel.support_length;
    const V3<float> g_2h{d.gx * to_m, d.gy * to_m, d.gz * to_m};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.at, g, frame);
        F support{}, p{};
        V3<F> flux{F{}, F{}, F{}};
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const F WV = ij.FV * ij.shape();
            support += WV;
            const float rho = d.rho0 + d.motion[j].drho;
            const F p_there = WV * (d.stress[j].p - rho * dot(g_2h, ij.r_ji));
            p += p_there;
            if (d.flux) {
                flux.x += p_there * d.carried[j].x;
                flux.y += p_there * d.carried[j].y;
                flux.z += p_there * d.carried[j].z;
            }
        });
        support *= d.kernel.tenth_h;
        p *= d.kernel.tenth_h;
        // below this the point has lost the water: a hundredth of the support at a plane wall
        const F inv = support > 0.005f ? 1.0f / support : F{};
        for (int l = 0; l < g.size; ++l) {
            const int i = g.first + l;
            d.p[i] = p[l] * inv[l];
            if (d.support) d.support[i] = support[l];
            if (d.flux) {
                d.flux[3 * i] = flux.x[l] * d.kernel.tenth_h * inv[l];
                d.flux[3 * i + 1] = flux.y[l] * d.kernel.tenth_h * inv[l];
                d.flux[3 * i + 2] = flux.z[l] * d.kernel.tenth_h * inv[l];
            }
        }
    }
}

GroupReach reach_of(const PlaceRecord* places, const Group& g, const Reaches& reaches) {
    GroupReach r;
    for (int l = 0; l < lanes; ++l) {
        const PlaceRecord& p = places[g.first + (l < g.size ? l : g.size - 1)];
        const float x = static_cast<float>(p.x - g.x), y = static_cast<float>(p.y - g.y),
                    z = static_cast<float>(p.z - g.z);
        r.n[l] = x * x + y * y + z * z;
        r.a[l] = -2 * x, r.b[l] = -2 * y, r.c[l] = -2 * z;
    }
    r.x = g.x, r.y = g.y, r.z = g.z;
    r.far2 = static_cast<float>(reaches.far * reaches.far) * 1.000002f;
    r.now2 = static_cast<float>(reaches.now * reaches.now) * 1.000002f;
    r.sure2 = static_cast<float>(reaches.sure > 0 ? reaches.sure * reaches.sure : 0);
    return r;
}

/// Eight records as three vectors.
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

/// Squared distance of eight places from the nearest of the group's particles [quanta^2].
inline F distance2(const GroupReach& g, const Places8& q) {
    const F x = __builtin_convertvector(q.x - g.x, F), y = __builtin_convertvector(q.y - g.y, F),
            z = __builtin_convertvector(q.z - g.z, F);
    F least = g.n[0] + g.a[0] * x + g.b[0] * y + g.c[0] * z;
    for (int l = 1; l < lanes; ++l) least = simd::min(least, g.n[l] + g.a[l] * x + g.b[l] * y + g.c[l] * z);
    return least + (x * x + y * y + z * z);
}

Reached reached(const GroupReach& g, const PlaceRecord* first, const PlaceRecord* end, int count, std::int64_t top) {
    Reached r{0, 0, 0};
    for (int k = 0; k < count && first[k].z <= top; k += 8) {
        PlaceRecord last[8];
        const PlaceRecord* p = first + k;
        if (end - p < 8) {
            for (int m = 0; m < 8; ++m) last[m] = p + m < end ? p[m] : p[0];
            p = last;
        }
        const I4* v = reinterpret_cast<const I4*>(p);
        const F d2 = distance2(g, transposed(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]));
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
            for (int k = 0; k < 7; ++k) index[doubtful + k] = index[0];
            for (int k = 0; k < doubtful; k += 8)
                within[k / 8] = static_cast<unsigned char>(simd::bits_below(
                    distance2(own, transposed(record(k), record(k + 1), record(k + 2), record(k + 3), record(k + 4),
                                              record(k + 5), record(k + 6), record(k + 7))),
                    own.now2));
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

extern const Passes table;
#ifdef TW_WITHOUT_EFFECTS
const Passes table = {
    TW_ISA_NAME, prune, continuity_and_gradient, forces, extrapolate, reach_of, reached, {}, {}, {}, {}, {}, {}, {}};
#else
const Passes table = {TW_ISA_NAME,
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
                      press_other_phase};
#endif

}  // namespace TW_ISA
}  // namespace tw
