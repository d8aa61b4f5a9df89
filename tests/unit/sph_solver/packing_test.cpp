// How closely particles stand, against what their densities say.
#include <gtest/gtest.h>

#include <cmath>

#include "sph_solver/measure/packing.h"

namespace tw {
namespace packing_test {

/// Water that fills a periodic box without gravity, 20 spacings high between walls, as a lattice whose columns stand
/// `factor` times a spacing apart, though the particles' densities are that of a whole spacing.
double crowding_of(double factor) {
    SimulationSetup s;
    s.dimensions = 2;
    s.gravity = Vec3::Zero();
    s.dp = 0.05;
    s.state_equation.c0 = 10;
    s.mirrors.periodic = {true, false, false};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.domain = {Vec3(0, -1, 0), Vec3(2, 1, 1)};
    Fluid water = fill_with_fluid(s, {s.domain});
    s.domain.max.x() *= factor;
    for (Vec3& place : water.places) place.x() *= factor;
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    EXPECT_TRUE(std::isnan(crowding(simulation))) << "nothing is known before the first evaluation";
    simulation.step();
    return crowding(simulation);
}

TEST(Crowding, IsTheShareOfTheRoomThatParticlesDoNotTake) {
    const double lattice = crowding_of(1);  // the sum over a lattice with h = 1.5 dp is 1.0047
    EXPECT_NEAR(lattice, 0, 5e-3);
    EXPECT_NEAR(crowding_of(0.95) - lattice, 0.05, 1e-3);
    EXPECT_NEAR(crowding_of(1.03) - lattice, -0.03, 1e-3);
}

}  // namespace packing_test
}  // namespace tw
