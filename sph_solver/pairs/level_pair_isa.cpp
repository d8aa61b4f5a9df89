// The sweeps across the contact of two levels, once per instruction set; equations in level_pair.h.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace TW_ISA {

namespace {
/// rho_other / (rho_own + rho_other): how much of a pair's compression is taken by `own`.
float share(const PassData& own, const PassData& other) { return other.rho0 / (own.rho0 + other.rho0); }
}  // namespace

void meet_other_phase(const LevelPairData& c, const Group* groups, int count) {
    const PassData &d = *c.own, &other = *c.other;
    const Frame frame = frame_of(d.kernel, d.quantum);
    const ShiftWeight weight(d);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        const V3<F> u = velocities(d, g);
        F divergence{}, support{};
        V3<F> s{F{}, F{}, F{}};
        for_each_neighbour(other.place, c.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            weight.count_in(ij, support, s);
            const VelocityDensityRecord& mj = other.motion[j];
            Continuity::add(ij.gradient(), V3<F>{u.x - mj.u, u.y - mj.v, u.z - mj.w}, divergence);
        });
        support *= d.kernel.tenth_h;
        divergence *= 2 * share(d, other);
        for (int l = 0; l < g.size; ++l) c.sums[g.first + l] = {s.x[l], s.y[l], s.z[l], support[l], divergence[l]};
    }
}

void press_other_phase(const LevelPairData& c, const Group* groups, int count) {
    const PassData &d = *c.own, &other = *c.other;
    const Frame frame = frame_of(d.kernel, d.quantum);
    const float of_own = 2 * share(d, other), of_other = 2 * share(other, d);
    const float both = d.viscosity + other.viscosity;
    const ArtificialViscosity artificial_viscosity{both > 0 ? 2 * d.viscosity * other.viscosity / both : 0};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        const V3<F> u = velocities(d, g);
        F p_i{}, V_i{};
        for (int l = 0; l < lanes; ++l) {
            const int i = g.first + (l < g.size ? l : g.size - 1);
            p_i[l] = d.stress[i].p;
            V_i[l] = d.place[i].volume;
        }
        F controlled = p_i;
        control_tension(d, g, controlled);
        const F p_own = of_own * p_i + (controlled - p_i);
        V3<F> force{F{}, F{}, F{}};
        for_each_neighbour(other.place, c.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& mj = other.motion[j];
            const V3<F> u_ij{u.x - mj.u, u.y - mj.v, u.z - mj.w};
            PressureGradient::add(ij, p_own + of_other * other.stress[j].p + artificial_viscosity.pressure(ij, u_ij),
                                  force);
        });
        const F inv_rho = V_i * d.inv_mass;
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
