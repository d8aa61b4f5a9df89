// Water and air together (air.h) in violent motion: what has to be kept, and what must not grow.
#include <gtest/gtest.h>

#include <cstdio>

#include "sph_solver/air.h"
#include "watched_run.h"

namespace tw {
namespace air_test {

double water_energy(const Simulation& s) {
    double potential = 0;
    for (const double z : s.particles().z) potential -= s.mass() * s.setup().gravity.z() * z;
    return sums_of(s).energy + elastic_of(s) + potential;
}

/// A column collapses in a closed tank full of air, strikes the far wall, and closes over pockets: no particle is lost,
/// no energy made, and the air is all there.
TEST(AirStability, AColumnCollapsesUnderALid) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.025;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, -1, 0), Vec3(1.2, 1, 0.8)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    const std::vector<Box> column{{Vec3(0, -1, 0), Vec3(0.4, 1, 0.5)}};
    Simulation simulation(s, fill_with_fluid(s, column));
    AirOptions air;
    air.sound_speed = 120;
    add_air(simulation, air, fill_with_air(s, column));
    const std::size_t water = simulation.particles().size(), gas = simulation.gas()->fields().particles().size();
    const double before = water_energy(simulation) + gas_energy(*simulation.gas(), simulation.setup().gravity);
    double most = before, fastest_air = 0, highest = 0;
    while (simulation.time() < 1.2) {
        run_on(simulation, simulation.time() + 0.02, 0.5, 0.2);
        if (testing::Test::HasFatalFailure()) return;
        most = std::max(most, water_energy(simulation) + gas_energy(*simulation.gas(), simulation.setup().gravity));
        fastest_air = std::max(fastest_air, simulation.gas()->system().extremes.speed);
        for (const double z : simulation.particles().z) highest = std::max(highest, z);
    }
    const double after = water_energy(simulation) + gas_energy(*simulation.gas(), simulation.setup().gravity);
    std::printf(
        "collapse under a lid: energy %.1f, at most %.1f, at the end %.1f J; air at most %.1f m/s; splash to %.2f m\n",
        before, most, after, fastest_air, highest);
    EXPECT_EQ(simulation.particles().size(), water);
    EXPECT_EQ(simulation.gas()->fields().particles().size(), gas);
    EXPECT_EQ(simulation.gas()->system().ledger.lost, 0);
    EXPECT_LT(most, before * 1.001);
    EXPECT_LT(after, before);
    EXPECT_LT(fastest_air, 0.5 * air.sound_speed);
    EXPECT_GT(highest, 0.5);  // it did strike the wall
}

/// A square of water flies through compressed air without bounds: momentum goes from the one to the other and is kept.
TEST(AirStability, MomentumIsKept) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.05;
    s.state_equation.c0 = 60;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(0, -1, 0), Vec3(2, 1, 2)};
    s.mirrors.periodic = {true, false, true};
    const std::vector<Box> block{{Vec3(0.6, -1, 0.6), Vec3(1.4, 1, 1.4)}};
    Simulation simulation(s, weightless(s, block[0]));
    add_air(simulation, {}, fill_with_air(s, block));
    // 20 kPa everywhere: no tension anywhere
    const auto press = [](const FieldsToSet& p, const LevelSetup& of) {
        for (float& drho : p.drho) drho = of.state_equation.deviation(of.rho0, 2e4);
    };
    press(simulation.fields_to_set(), simulation.setup());
    press(simulation.gas()->fields_to_set(), simulation.gas()->system().setup);
    for (float& u : simulation.fields_to_set().u) u = 3;
    const double before = sums_of(simulation).x;
    while (simulation.time() < 0.05) simulation.step();
    const double gained = sums_of(*simulation.gas()).x, after = sums_of(simulation).x + gained;
    std::printf("momentum %.6f of %.6f N s; the air has %.2g of it\n", after, before, gained / before);
    EXPECT_NEAR(after, before, 2e-6 * before);
    EXPECT_GT(gained, 1e-5 * before);
}

}  // namespace air_test
}  // namespace tw
