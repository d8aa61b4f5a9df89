#pragma once
// What the hard cases share: how they are set up and what is watched while they run.
#include <gtest/gtest.h>

#include <cmath>

#include "sph_solver/simulation.h"

namespace tw {

/// Two dimensions (x, z), no gravity, free surface all round.
inline SimulationSetup plane(double dp, double c0, double half_width) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = c0;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(-half_width, -1, -half_width), Vec3(half_width, 1, half_width)};
    return s;
}

inline Fluid weightless(const SimulationSetup& s, const Box& block) {
    Fluid water = fill_with_fluid(s, {block});
    for (double& depth : water.depth) depth = 0;
    return water;
}

/// Kinetic energy [J], momentum [N s] and angular momentum [N m s] per metre of width.
struct Sums {
    double energy = 0, x = 0, z = 0, turn = 0;
};
inline Sums sums_of(const Level& level) {
    Sums s;
    const Particles& p = level.fields().particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double m = level.system().mass, u = p.u[i], w = p.w[i];
        s.energy += 0.5 * m * (u * u + w * w);
        s.x += m * u, s.z += m * w;
        s.turn += m * (p.z[i] * u - p.x[i] * w);
    }
    return s;
}
inline Sums sums_of(const Simulation& simulation) { return sums_of(simulation.level(0)); }

/// Energy of the compressed water [J]: part of what the start may turn into motion.
inline double elastic_of(const Simulation& simulation) {
    const double c0 = simulation.setup().state_equation.c0, rho0 = simulation.setup().rho0;
    double energy = 0;
    for (const float drho : simulation.particles().drho)
        energy += 0.5 * simulation.mass() * c0 * c0 * double(drho) * drho / (rho0 * rho0);
    return energy;
}

/// Steps on and watches what has to stay bounded all the while.
inline void run_on(Simulation& simulation, double until, double largest_mach_number, double largest_deviation) {
    const double c0 = simulation.setup().state_equation.c0, rho0 = simulation.setup().rho0;
    while (simulation.time() < until) {
        simulation.step();
        const Extremes& e = simulation.extremes();
        ASSERT_LT(e.speed, largest_mach_number * c0) << simulation.time();
        ASSERT_LT(e.density_deviation_high, largest_deviation * rho0) << simulation.time();
        ASSERT_GT(e.density_deviation_low, -largest_deviation * rho0) << simulation.time();
    }
    EXPECT_EQ(simulation.ledger().lost, 0);
}

}  // namespace tw
