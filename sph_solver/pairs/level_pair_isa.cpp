// The sweeps across the contact of two fluids, once per instruction set; equations in equations/level_pair.h.
#include "sph_solver/equations/level_pair.h"

#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"
#include "sph_solver/equations/artificial_viscosity.h"
#include "sph_solver/equations/continuity.h"
#include "sph_solver/equations/pressure_gradient.h"
#include "sph_solver/equations/shifting.h"

namespace tw {
namespace TW_ISA {

void meet_other_phase(const LevelPairData& c, const Group* groups, int count) {
    const PassData &d = *c.own, &other = *c.other;
    const Frame frame = frame_of(d.kernel, d.quantum);
    const Shifting shifting(d.kernel, d.inv_W_dp);
    const Contact contact(d.rho0, other.rho0);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        Real divergence{}, support{}, difference2{};
        V3<Real> shift{};
        for_each_neighbour(other.place, c.list, g.list, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            support += ij.V_W();
            shifting.add(ij, shift);
            const V3<Real> u_ij = u_i - velocity(other.motion[j]);
            Shifting::add_difference(ij, u_ij, difference2);
            Continuity::add(ij, u_ij, divergence);
        });
        support *= d.kernel.W_over_G, difference2 *= d.kernel.W_over_G;
        divergence *= contact.of_own;
        for (int l = 0; l < g.size; ++l)
            c.sums[g.first + l] = {shift.x[l], shift.y[l], shift.z[l], support[l], divergence[l], difference2[l]};
    }
}

void press_other_phase(const LevelPairData& c, const Group* groups, int count) {
    const PassData &d = *c.own, &other = *c.other;
    const Frame frame = frame_of(d.kernel, d.quantum);
    const Contact contact(d.rho0, other.rho0);
    const ArtificialViscosity<Math> artificial_viscosity{harmonic_mean(d.viscosity, other.viscosity)};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame), u_i = own_velocities(d.motion, g);
        const Real p_i = own(g, [&](int i) { return d.stress[i].p; });
        const Real V_i = own(g, [&](int i) { return d.place[i].volume; });
        Real controlled = p_i;
        control_tension(d, g, controlled);
        const Real p_own = contact.of_own * p_i + (controlled - p_i);
        V3<Real> force{};
        for_each_neighbour(other.place, c.list, g.list, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            const V3<Real> u_ij = u_i - velocity(other.motion[j]);
            PressureGradient::add(
                ij, p_own + contact.of_other * other.stress[j].p + artificial_viscosity.pressure(ij, u_ij), force);
        });
        const Real inv_rho = V_i * d.inv_mass;
        for (int l = 0; l < g.size; ++l) {
            RateRecord& rate = d.rate[g.first + l];
            rate.ax += force.x[l] * inv_rho[l];
            rate.ay += force.y[l] * inv_rho[l];
            rate.az += force.z[l] * inv_rho[l];
        }
    }
}

}  // namespace TW_ISA
}  // namespace tw
