// A film of water that turns through a right angle along a circular wall, without gravity. Nothing slows it down, so
// the wall has to turn its momentum: the force of the water on the wall is
//
//   F = rho U^2 delta (e_in - e_out)
//
// per metre of width, however thin the film is, and the pressure on the wall rho U^2 delta / R (momentum theorem; for
// delta << R). A hull's spray root leaves such films, a spacing or less thick.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "prism.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace film_on_wall_test {

constexpr double R = 1, delta = 0.1, U = 1, length = 4;  // of the bend and of the film [m], [m/s]

/// A floor to x = 0, a quarter of a circle, a wall upwards from (R, R): its section is seen whole from its corner.
Surface bend() {
    const double thickness = 0.5;
    std::vector<std::pair<double, double>> section{{R + thickness, -thickness}, {R + thickness, R + 1.5}, {R, R + 1.5}};
    const int facets = 90;
    for (int k = 0; k <= facets; ++k) {
        const double angle = std::numbers::pi / 2 * k / facets;
        section.emplace_back(R * std::cos(angle), R - R * std::sin(angle));
    }
    section.emplace_back(-length - 0.3, 0);
    section.emplace_back(-length - 0.3, -thickness);
    return prism_along_y(section, 3);
}

struct Film {
    Vec3 force = Vec3::Zero();  ///< mean while the bend is full, over rho U^2 delta [-]
};

Film turn(double delta_over_dp) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = delta / delta_over_dp;
    s.state_equation.c0 = 10 * U;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(-length - 0.5, -1, -1), Vec3(3, 1, 9)};
    s.bodies = {bend()};
    Fluid water = fill_with_fluid(s, {Box{Vec3(-length, -1, 0), Vec3(0, 1, delta)}});
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    for (float& u : simulation.fields_to_set().u) u = static_cast<float>(U);
    const double full = (std::numbers::pi / 2 * R + 0.6) / U, until = 0.95 * length / U;
    Vec3 impulse = Vec3::Zero();
    double from = 0, before = 0;
    while (simulation.time() < until) {
        simulation.step();
        if (simulation.time() > full) {
            if (from == 0) from = before;
            impulse += simulation.load().force * (simulation.time() - before);
        }
        before = simulation.time();
    }
    return {impulse / (before - from) / (s.rho0 * U * U * delta)};
}

TEST(FilmOnWall, ItsMomentumIsTurnedHoweverThinItIs) {
    std::printf("delta/dp | force along the inflow, against the outflow, over rho U^2 delta\n");
    for (const double delta_over_dp : {1.0, 2.0, 4.0}) {
        const Film film = turn(delta_over_dp);
        std::printf("   %4g  | %.4f  %.4f\n", delta_over_dp, film.force.x(), -film.force.z());
        EXPECT_NEAR(film.force.x(), 1, 0.03) << delta_over_dp;
        EXPECT_NEAR(-film.force.z(), 1, 0.03) << delta_over_dp;
    }
}

}  // namespace film_on_wall_test
}  // namespace tw
