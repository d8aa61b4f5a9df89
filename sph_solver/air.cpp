#include "sph_solver/air.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/exact_sum.h"
#include "sph_solver/effects/moving_tank.h"

namespace tw {

namespace {

LevelSetup air_setup(LevelSetup s, const AirOptions& air) {
    s.material = "air";
    s.rho0 = air.density;
    s.state_equation = {};
    s.state_equation.form = StateEquation::Form::tait;
    s.state_equation.c0 = air.sound_speed;
    s.state_equation.gamma = air.heat_capacities;
    s.largest_compression = 10,
    s.largest_rarefaction = 0.95;  // 33 and 0.015 atmospheres: beyond any scene, short of nonsense
    s.tension_control = true;
    s.shut_in = true;
    return s;
}

/// Shepard sum, by water and air together, below which water lies at a void. Chosen, not derived: below the 0.75
/// that water alone gives at a flat surface, so that a surface short of air does not count.
constexpr double support_at_a_void = 0.6;

}  // namespace

void add_air(Simulation& simulation, const AirOptions& air, const Fluid& fluid) {
    const auto particles = static_cast<std::int64_t>(fluid.places.size());
    if (simulation.level(0).system().ranks().sum(particles) == 0)
        throw InputError("air: the water leaves no room for it in the domain");
    Mirrors& mirrors = simulation.surroundings().mirrors;
    if (!mirrors.periodic[2]) mirrors.on[2][1] = true;
    simulation.level(0).set_surface_support(support_at_a_void);
    EffectOptions effects;
    if (simulation.surroundings().frame) effects.push_back(MovingTank{});
    simulation.add_gas(air_setup(simulation.level(0).system().setup, air), effects, fluid);
}

double gas_energy(const Level& gas, const Vec3& gravity) {
    const LevelSetup& s = gas.system().setup;
    const Particles& p = gas.fields().particles();
    const double gamma = s.state_equation.gamma, c2 = s.state_equation.c0 * s.state_equation.c0;
    const ExactSum sum = gas.fields().sum_over_all<ExactSum>([&](ExactSum& energy, std::size_t i) {
        const double x = 1 + double(p.drho[i]) / s.rho0;
        energy += 0.5 * (double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]) -
                  gravity.z() * p.z[i] +
                  c2 / gamma * (std::pow(x, gamma - 1) / (gamma - 1) + 1 / x - gamma / (gamma - 1));
    });
    return gas.system().mass * sum.value();
}

}  // namespace tw
