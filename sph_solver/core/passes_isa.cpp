// The neighbour loops, compiled once per instruction set (TW_ISA names it). Nothing here may call inline functions of
// the standard library: the linker would be free to keep this file's AVX-512 copy for the whole program.
#include "sph_solver/core/pair_loop.h"

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
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, d.quantum);
        V3<F> u{}, n_i{};
        F drho_i{};
        for (int l = 0; l < lanes; ++l) {
            const MotionRecord& r = d.motion[g.first + (l < g.size ? l : g.size - 1)];
            u.x[l] = r.u;
            u.y[l] = r.v;
            u.z[l] = r.w;
            drho_i[l] = r.drho;
        }
        F m[6] = {}, divergence{}, wall_divergence{};
        V3<F> b{F{}, F{}, F{}}, s{F{}, F{}, F{}};
        F support{};

        // what water and wall neighbours have in common: support and shifting sum
        const auto meet = [&](const float* xyz) {
            const V3<F> r{xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z};
            const KernelShape k = shape(r, d.kernel.inv_h);
            const F t2 = k.t * k.t;
            const F FV = (d.kernel.five_sigma * xyz[3]) * t2 * k.t;
            const F W = d.kernel.sigma * (t2 * t2) * (k.q + k.q + 1.0f);
            support += W * xyz[3];
            const F ratio = W * d.inv_W_dp, ratio2 = ratio * ratio;
            const F fs = FV + 0.2f * FV * ratio2 * ratio2;
            s.x += fs * r.x;
            s.y += fs * r.y;
            s.z += fs * r.z;
            return Pair<F>{r, k.r2, FV};
        };
        for_each_neighbour(d.place, g.list, g.list_size, g, d.quantum, [&](std::int32_t j, const float* xyz) {
            const Pair<F> ij = meet(xyz);
            const V3<F>& r = ij.r_ji;
            const F fx = ij.FV * r.x, fy = ij.FV * r.y, fz = ij.FV * r.z;
            m[0] += fx * r.x;
            m[1] += fx * r.y;
            m[2] += fx * r.z;
            m[3] += fy * r.y;
            m[4] += fy * r.z;
            m[5] += fz * r.z;
            const MotionRecord& mj = d.motion[j];
            Continuity::add(ij, V3<F>{u.x - mj.u, u.y - mj.v, u.z - mj.w}, divergence);
            const F jump = mj.drho - drho_i;
            b.x += jump * fx;
            b.y += jump * fy;
            b.z += jump * fz;
        });
        for (int l = 0; l < lanes && g.wall_size > 0; ++l) {
            const NormalRecord& r = d.normal[g.first + (l < g.size ? l : g.size - 1)];
            n_i.x[l] = r.x;
            n_i.y[l] = r.y;
            n_i.z[l] = r.z;
        }
        const F u_n = dot(u, n_i);
        const V3<F> u_iw{u_n * n_i.x, u_n * n_i.y, u_n * n_i.z};
        for_each_neighbour(d.wall_place, g.wall_list, g.wall_size, g, d.quantum,
                           [&](std::int32_t, const float* xyz) { Continuity::add(meet(xyz), u_iw, wall_divergence); });
        if (g.wall_size > 0) {
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
            StressRecord& out = d.stress[g.first + l];
            out.gx = grad.x[l];
            out.gy = grad.y[l];
            out.gz = grad.z[l];
            d.rate[g.first + l].drho = (d.rho0 + drho_i[l]) * divergence[l];
            d.shift[g.first + l] = {s.x[l], s.y[l], s.z[l], support[l]};
        }
    }
}

/// Second sweep: pressure, artificial viscosity and density diffusion. Walls press, and do not rub (slip).
void forces(const PassData& d, const Group* groups, int count) {
    const ArtificialViscosity artificial_viscosity{d.viscosity, d.eta2};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, d.quantum);
        V3<F> u{}, grad{};
        F drho_i{}, p_i{}, V_i{};
        for (int l = 0; l < lanes; ++l) {
            const int i = g.first + (l < g.size ? l : g.size - 1);
            u.x[l] = d.motion[i].u;
            u.y[l] = d.motion[i].v;
            u.z[l] = d.motion[i].w;
            drho_i[l] = d.motion[i].drho;
            grad.x[l] = d.stress[i].gx;
            grad.y[l] = d.stress[i].gy;
            grad.z[l] = d.stress[i].gz;
            p_i[l] = d.stress[i].p;
            V_i[l] = d.place[i].volume;
        }
        // Tension control (Sun et al. 2018, doi:10.1016/j.cpc.2017.11.016): inside the water p_j - p_i in place of p_j
        // + p_i where p_i < 0, so that stretched water does not clump. Not beside walls, where the pair forces are the
        // load.
        if (d.tension_control_from < 1.5f && g.wall_size == 0)
            for (int l = 0; l < lanes; ++l)
                if (d.shift[g.first + (l < g.size ? l : g.size - 1)].support > d.tension_control_from && p_i[l] < 0)
                    p_i[l] = -p_i[l];
        F diffusion{};
        V3<F> towards_surface{F{}, F{}, F{}};
        V3<F> pressure{F{}, F{}, F{}}, viscous{F{}, F{}, F{}}, wall{F{}, F{}, F{}};

        const auto meet = [&](const float* xyz) {
            const V3<F> r{xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z};
            const KernelShape k = shape(r, d.kernel.inv_h);
            return Pair<F>{r, k.r2, (d.kernel.five_sigma * xyz[3]) * (k.t * k.t) * k.t};
        };
        for_each_neighbour(d.place, g.list, g.list_size, g, d.quantum, [&](std::int32_t j, const float* xyz) {
            const MotionRecord& mj = d.motion[j];
            const StressRecord& sj = d.stress[j];
            const Pair<F> ij = meet(xyz);
            const V3<F> u_ij{u.x - mj.u, u.y - mj.v, u.z - mj.w};
            DensityDiffusion::add(ij, mj.drho - drho_i, V3<F>{grad.x + sj.gx, grad.y + sj.gy, grad.z + sj.gz},
                                  diffusion);
            PressureGradient::add(ij, p_i + sj.p, pressure);
            artificial_viscosity.add(ij, u_ij, viscous);
            const F s = ij.FV * d.surface[j];
            towards_surface.x += s * ij.r_ji.x;
            towards_surface.y += s * ij.r_ji.y;
            towards_surface.z += s * ij.r_ji.z;
        });

        for_each_neighbour(d.wall_place, g.wall_list, g.wall_size, g, d.quantum, [&](std::int32_t j, const float* xyz) {
            const Pair<F> ij = meet(xyz);
            PressureGradient::add(ij, p_i + d.wall_p[j], wall);
        });
        // The volume that the neighbours see, not this density's: so the forces of a pair cancel to rounding.
        const F inv_rho = V_i * d.inv_mass;
        const F drho = d.diffusion * diffusion;
        const V3<F> w{wall.x * inv_rho, wall.y * inv_rho, wall.z * inv_rho};
        const V3<F> acc{(pressure.x + viscous.x) * inv_rho + w.x + d.gx,
                        (pressure.y + viscous.y) * inv_rho + w.y + d.gy,
                        (pressure.z + viscous.z) * inv_rho + w.z + d.gz};
        const F normal2 = dot(towards_surface, towards_surface);
        for (int l = 0; l < g.size; ++l) {
            const int i = g.first + l;
            d.rate[i] = {acc.x[l], acc.y[l], acc.z[l], drho[l]};
            // shifting goes along the surface only: towards it, it would pump water up for ever
            if (normal2[l] > 0) {
                ShiftRecord& s = d.shift[i];
                const float x = towards_surface.x[l], y = towards_surface.y[l], z = towards_surface.z[l];
                const float share = (s.x * x + s.y * y + s.z * z) / normal2[l];
                s.x -= share * x, s.y -= share * y, s.z -= share * z;
            }
        }
        if (g.wall_load >= 0) d.wall_load[g.wall_load] = load_of(a, w, g.size);
    }
}

/// Fields at points from the fluid round them (Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005):
///   p_b = sum_f (p_f + rho_f g . (x_b - x_f)) V_f W_bf / sum_f V_f W_bf
void extrapolate(const ExtrapolateData& d, const Group* groups, int count) {
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.at, g, d.quantum);
        F support{}, p{};
        V3<F> flux{F{}, F{}, F{}};
        for_each_neighbour(d.place, g.list, g.list_size, g, d.quantum, [&](std::int32_t j, const float* xyz) {
            const V3<F> r{xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z};
            const KernelShape k = shape(r, d.kernel.inv_h);
            const F t2 = k.t * k.t;
            const F WV = (d.kernel.sigma * xyz[3]) * (t2 * t2) * (k.q + k.q + 1.0f);
            support += WV;
            const float rho = d.rho0 + d.motion[j].drho;
            const F p_there = WV * (d.stress[j].p - rho * (d.gx * r.x + d.gy * r.y + d.gz * r.z));
            p += p_there;
            if (d.flux) {
                flux.x += p_there * d.carried[j].x;
                flux.y += p_there * d.carried[j].y;
                flux.z += p_there * d.carried[j].z;
            }
        });
        // below this the point has lost the water: a hundredth of the support at a plane wall
        const F inv = support > 0.005f ? 1.0f / support : F{};
        for (int l = 0; l < g.size; ++l) {
            const int i = g.first + l;
            d.p[i] = p[l] * inv[l];
            if (d.support) d.support[i] = support[l];
            if (d.flux) {
                d.flux[3 * i] = flux.x[l] * inv[l];
                d.flux[3 * i + 1] = flux.y[l] * inv[l];
                d.flux[3 * i + 2] = flux.z[l] * inv[l];
            }
        }
    }
}

std::uint32_t reached(const GroupPlaces& group, const Group& g, const PlaceRecord* first, std::uint32_t mask,
                      float reach2) {
    const F x = *reinterpret_cast<const F*>(group.x), y = *reinterpret_cast<const F*>(group.y),
            z = *reinterpret_cast<const F*>(group.z);
    std::uint32_t kept = 0;
    for (std::uint32_t left = mask; left != 0; left &= left - 1) {
        const PlaceRecord& p = first[__builtin_ctz(left)];
        const V3<F> r{x - static_cast<float>(p.x - g.x), y - static_cast<float>(p.y - g.y),
                      z - static_cast<float>(p.z - g.z)};
        if (simd::any_below(dot(r, r), reach2)) kept |= left & (0u - left);
    }
    return kept;
}

}  // namespace

void water_velocity(const VelocityData&, const Group*, int);
void viscous_forces(const ViscousData&, const Group*, int);
void strain_rate(const StrainData&, const Group*, int);
void colour_gradient(const ColourData&, const Group*, int);
void surface_curvature(const ColourData&, const Group*, int);

extern const Passes table;
#ifdef TW_WITHOUT_EFFECTS
const Passes table = {TW_ISA_NAME, continuity_and_gradient, forces, extrapolate, reached, {}, {}, {}, {}, {}};
#else
const Passes table = {TW_ISA_NAME,    continuity_and_gradient, forces,      extrapolate,     reached,
                      water_velocity, viscous_forces,          strain_rate, colour_gradient, surface_curvature};
#endif

}  // namespace TW_ISA
}  // namespace tw
