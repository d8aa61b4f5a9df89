// The sweeps of viscosity and subgrid turbulence, once per instruction set; equations in viscosity.h, eddy_viscosity.h.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace TW_ISA {

void water_velocity(const VelocityData& v, const Group* groups, int count) {
    const PassData& d = *v.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(v.at, g, frame);
        V3<F> u{F{}, F{}, F{}};
        F support{};
        for_each_neighbour(d.place, v.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const F WV = ij.FV * ij.shape();
            const VelocityDensityRecord& m = d.motion[j];
            support += WV;
            u.x += WV * m.u, u.y += WV * m.v, u.z += WV * m.w;
        });
        support *= d.kernel.tenth_h;
        const F inv = support > 0.005f ? d.kernel.tenth_h / support : F{};
        for (int l = 0; l < g.size; ++l)
            v.velocity[g.first + l] = {u.x[l] * inv[l], u.y[l] * inv[l], u.z[l] * inv[l], support[l]};
    }
}

void viscous_forces(const ViscousData& v, const Group* groups, int count) {
    const PassData& d = *v.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        V3<F> u{};
        F mu_i{}, V_i{};
        for (int l = 0; l < lanes; ++l) {
            const int i = g.first + (l < g.size ? l : g.size - 1);
            u.x[l] = d.motion[i].u, u.y[l] = d.motion[i].v, u.z[l] = d.motion[i].w;
            mu_i[l] = v.mu[i];
            V_i[l] = d.place[i].volume;
        }
        V3<F> inner{F{}, F{}, F{}}, wall{F{}, F{}, F{}};
        const auto add = [&](const Met& ij, const F& mu_sum, const VelocityDensityRecord& m, V3<F>& force) {
            const F f = ij.FV * mu_sum;
            force.x += f * (m.u - u.x);
            force.y += f * (m.v - u.y);
            force.z += f * (m.w - u.z);
        };
        for_each_neighbour(d.place, d.list, g.list, g, frame, a,
                           [&](std::int32_t j, const Met& ij) { add(ij, mu_i + v.mu[j], d.motion[j], inner); });
        if (v.wall_velocity)
            for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, a, [&](std::int32_t j, const Met& ij) {
                if (v.wall_velocity[j].drho > 0.005f) add(ij, 2.0f * mu_i, v.wall_velocity[j], wall);
            });
        const F inv_rho = V_i * (d.inv_mass * d.kernel.inv_support);  // F V = FV / 2h
        const V3<F> w{wall.x * inv_rho, wall.y * inv_rho, wall.z * inv_rho};
        for (int l = 0; l < g.size; ++l) {
            RateRecord& r = d.rate[g.first + l];
            r.ax += inner.x[l] * inv_rho[l] + w.x[l];
            r.ay += inner.y[l] * inv_rho[l] + w.y[l];
            r.az += inner.z[l] * inv_rho[l] + w.z[l];
        }
        if (v.wall_velocity && g.wall_load >= 0)
            v.wall_load[g.wall_load] = load_of(a, d.kernel.support_length, w, g.size);
    }
}

void strain_rate(const StrainData& s, const Group* groups, int count) {
    const PassData& d = *s.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        const V3<F> u = velocities(d, g);
        VectorGradient gradient;
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& mj = d.motion[j];
            gradient.add(ij, V3<F>{mj.u - u.x, mj.v - u.y, mj.w - u.z});
        });
        gradient.solve(d.kernel.support_length, d.two_dimensional);
        const V3<F>&gu = gradient.u, &gv = gradient.v, &gw = gradient.w;
        const F xy = gu.y + gv.x, xz = gu.z + gw.x, yz = gv.z + gw.y;
        const F S2 = 2.0f * (gu.x * gu.x + gv.y * gv.y + gw.z * gw.z) + xy * xy + xz * xz + yz * yz;
        const F S = simd::sqrt(S2);
        for (int l = 0; l < g.size; ++l) s.strain[g.first + l] = S[l];
    }
}

}  // namespace TW_ISA
}  // namespace tw
