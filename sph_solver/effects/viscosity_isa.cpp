// The sweeps of viscosity and subgrid turbulence, once per instruction set; equations in equations/viscosity.h and
// equations/smagorinsky.h.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"
#include "sph_solver/equations/smagorinsky.h"
#include "sph_solver/equations/viscosity.h"
#include "sph_solver/equations/wall_pressure.h"

namespace tw {
namespace TW_ISA {

void water_velocity(const VelocityData& v, const Group* groups, int count) {
    const PassData& d = *v.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_d = own_places(v.at, g, frame);
        V3<Real> u{};
        Real support{};
        for_each_neighbour(d.place, v.list, g.list, g, frame, x_d, [&](std::int32_t f, const Met& ij) {
            const Real V_W = ij.V_W();
            support += V_W;
            u += V_W * velocity(d.motion[f]);
        });
        support *= d.kernel.W_over_G;
        const Real inv = support > WallPressure::least_support ? d.kernel.W_over_G / support : Real{};
        for (int l = 0; l < g.size; ++l)
            v.velocity[g.first + l] = {u.x[l] * inv[l], u.y[l] * inv[l], u.z[l] * inv[l], support[l]};
    }
}

void viscous_forces(const ViscousData& v, const Group* groups, int count) {
    const PassData& d = *v.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        const Real mu_i = own(g, [&](int i) { return v.mu[i]; });
        const Real V_i = own(g, [&](int i) { return d.place[i].volume; });
        V3<Real> inner{}, a_wall{};
        for_each_neighbour(d.place, d.list, list_for_rates(d, g), g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            ViscousForce::add(ij, mu_i + v.mu[j], velocity(d.motion[j]) - u_i, inner);
        });
        const Real inv_rho = V_i * (d.inv_mass * d.kernel.inv_support);
        const auto hold = [&](const ListRef& part, std::int32_t slot, std::int32_t body) {
            V3<Real> wall{};
            for_each_neighbour(d.wall_place, d.wall_list, part, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
                if (v.wall_velocity[j].drho > WallPressure::least_support)
                    ViscousForce::add(ij, 2.0f * mu_i, velocity(v.wall_velocity[j]) - u_i, wall);
            });
            const V3<Real> a_body = inv_rho * wall;
            a_wall += a_body;
            if (slot >= 0) v.wall_load[slot] = load_of(d, g, x_i, a_body, body);
        };
        if (v.wall_velocity) for_each_body(d, g, hold);
        for (int l = 0; l < g.size; ++l) {
            RateRecord& r = d.rate[g.first + l];
            r.ax += inner.x[l] * inv_rho[l] + a_wall.x[l];
            r.ay += inner.y[l] * inv_rho[l] + a_wall.y[l];
            r.az += inner.z[l] * inv_rho[l] + a_wall.z[l];
        }
    }
}

void strain_rate(const StrainData& s, const Group* groups, int count) {
    const PassData& d = *s.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        VectorGradient<Real> grad_u;
        for_each_neighbour(d.place, d.list, g.list, g, frame, x_i,
                           [&](std::int32_t j, const Met& ij) { grad_u.add(ij, velocity(d.motion[j]) - u_i); });
        grad_u.solve(d.kernel.support_length, d.two_dimensional);
        const Real S = simd::sqrt(strain_rate_squared(grad_u));
        for (int l = 0; l < g.size; ++l) s.strain[g.first + l] = S[l];
    }
}

}  // namespace TW_ISA
}  // namespace tw
