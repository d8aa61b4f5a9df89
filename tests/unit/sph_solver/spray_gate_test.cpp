// Water that leaves a run as droplets: what is taken, and what is left alone.
#include "sph_solver/measure/spray_gate.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sph_solver/simulation.h"

namespace tw {
namespace spray_gate_test {

constexpr double dp = 0.05;

SimulationSetup tank(int threads = 1) {
    SimulationSetup s;
    s.dp = dp;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.threads = threads;
    return s;
}
/// Water up to z = 0.3, a cube of eight particles above it at x = 0.2, and one at x = 0.8, both at z = 0.7 to 0.8.
Fluid sea_with_two_lumps(const SimulationSetup& s) {
    return fill_with_fluid(s, {Box{{0, 0, 0}, {1, 0.3, 0.3}}, Box{{0.2, 0.1, 0.7}, {0.3, 0.2, 0.8}},
                               Box{{0.8, 0.1, 0.7}, {0.9, 0.2, 0.8}}});
}
SphOptions gate_at(const std::vector<double>& point, const std::vector<double>& normal) {
    SphOptions o;
    o.gate_point = point, o.gate_normal = normal;
    return o;
}

struct Sums {
    double mass = 0, kinetic = 0;
    Vec3 momentum = Vec3::Zero();
};
Sums sums_of(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    Sums s;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 v(p.u[i], p.v[i], p.w[i]);
        s.mass += simulation.mass(), s.momentum += simulation.mass() * v;
        s.kinetic += 0.5 * simulation.mass() * v.squaredNorm();
    }
    return s;
}

TEST(SprayGate, TakesADetachedLumpWithItsMassMomentumAndEnergy) {
    Simulation simulation(tank(), sea_with_two_lumps(tank()));
    for (int n = 0; n < 3; ++n) simulation.step();
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i)  // the lump at x = 0.2 flies and turns
        if (p.z[i] > 0.5 && p.x[i] < 0.5) p.u[i] = 3, p.w[i] = p.z[i] > 0.75 ? 2 : 1;
    const Sums before = sums_of(simulation);
    const std::size_t count = p.size();

    const auto gate = SprayGate::of(gate_at({0.5, 0, 0}, {-1, 0, 0}));  // beyond: x < 0.5
    ASSERT_TRUE(gate);
    const std::vector<SprayLump> lumps = gate->take(simulation);
    ASSERT_EQ(lumps.size(), 1u);
    EXPECT_EQ(lumps[0].particles, 8);
    EXPECT_NEAR(lumps[0].place.x(), 0.25, 0.01);
    EXPECT_NEAR(lumps[0].velocity.x(), 3, 1e-6);
    EXPECT_NEAR(lumps[0].velocity.z(), 1.5, 1e-6);
    EXPECT_NEAR(lumps[0].inner_energy, 0.5 * lumps[0].mass * 0.25, 1e-4 * lumps[0].mass);

    const Sums after = sums_of(simulation);
    const double lump_energy = lumps[0].inner_energy + 0.5 * lumps[0].mass * lumps[0].velocity.squaredNorm();
    EXPECT_EQ(simulation.particles().size(), count - 8);
    EXPECT_EQ(simulation.ledger().out, 8);
    EXPECT_NEAR(after.mass + lumps[0].mass, before.mass, 1e-12 * before.mass);
    EXPECT_LT((after.momentum + lumps[0].mass * lumps[0].velocity - before.momentum).norm(),
              1e-12 * before.momentum.norm());
    EXPECT_NEAR(after.kinetic + lump_energy, before.kinetic, 1e-12 * before.kinetic);
    EXPECT_TRUE(gate->take(simulation).empty());     // once
    for (int n = 0; n < 20; ++n) simulation.step();  // and the rest goes on
    EXPECT_EQ(simulation.particles().size(), count - 8);
}

TEST(SprayGate, LeavesTheBodyOfWaterAndWhatHangsOnIt) {
    Simulation simulation(tank(), sea_with_two_lumps(tank()));
    simulation.step();
    const std::size_t count = simulation.particles().size();
    EXPECT_TRUE(SprayGate::of(gate_at({0, 0, 0.9}, {0, 0, 1}))->take(simulation).empty());
    // all water is beyond: the lumps go, the largest component never does
    EXPECT_EQ(SprayGate::of(gate_at({0, 0, -1}, {0, 0, 1}))->take(simulation).size(), 2u);
    EXPECT_EQ(simulation.particles().size(), count - 16);
    SphOptions far = gate_at({0, 0, 0.5}, {0, 0, 1});
    far.gate_link = 9;  // the lumps are eight spacings above the water
    Simulation linked(tank(), sea_with_two_lumps(tank()));
    linked.step();
    EXPECT_TRUE(SprayGate::of(far)->take(linked).empty());
    EXPECT_FALSE(SprayGate::of(SphOptions{}));
}

/// A lump across the edge between two sizes leaves as one, with the buffer particles and parents that stand for it:
/// what stays behind of either size is what a run without the lump has.
TEST(SprayGate, TakesALumpOfTwoSizesWithAllThatStandsForIt) {
    SimulationSetup s = tank();
    s.dp = dp / 2;
    s.zones = {Zone({Box{{-infinite, -infinite, -infinite}, {0.5, infinite, infinite}}})};
    const Box sea{{0, 0, 0}, {1, 0.3, 0.3}}, lump{{0.4, 0.1, 0.7}, {0.6, 0.2, 0.8}};
    const auto water = [&](const std::vector<Box>& boxes) { return fill_levels(s, boxes); };
    Simulation simulation(s, water({sea, lump})), without(s, water({sea}));
    for (int n = 0; n < 2; ++n) simulation.step(), without.step();
    const auto gate = SprayGate::of(gate_at({0, 0, 0.6}, {0, 0, 1}));
    const std::vector<SprayLump> lumps = gate->take(simulation);
    ASSERT_EQ(lumps.size(), 1u);
    EXPECT_EQ(lumps[0].particles, 8 + 8 * 8);
    EXPECT_NEAR(lumps[0].mass, 1000 * 0.2 * 0.1 * 0.1, 1e-9);
    EXPECT_NEAR(lumps[0].place.x(), 0.5, 1e-3);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(simulation.level(k).fields().particles().size(), without.level(k).fields().particles().size());
    for (int n = 0; n < 20; ++n) simulation.step();
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_LT(std::ranges::max(simulation.level(k).fields().particles().z), 0.35)
            << "nothing of it is left in size " << k;
}

/// What is left after water was taken out does not depend on threads, nor on whether it was saved and read.
TEST(SprayGate, AnyNumberOfThreadsAndARestartGiveTheSameBits) {
    const auto run = [](int threads, bool restart) {
        Simulation simulation(tank(threads), sea_with_two_lumps(tank(threads)));
        const auto gate = SprayGate::of(gate_at({0.5, 0, 0}, {1, 0, 0}));
        for (int n = 0; n < 10; ++n) simulation.step();
        EXPECT_EQ(gate->take(simulation).size(), 1u);
        Level& level = simulation.level(0);
        if (restart) level.restore(level.state(), Particles(level.fields().particles()));
        for (int n = 0; n < 30; ++n) simulation.step();
        return simulation.particles();
    };
    const Particles one = run(1, false), three = run(3, false), again = run(1, true);
    EXPECT_EQ(one.x, three.x);
    EXPECT_EQ(one.w, three.w);
    EXPECT_EQ(one.drho, three.drho);
    EXPECT_EQ(one.x, again.x);
    EXPECT_EQ(one.w, again.w);
    EXPECT_EQ(one.drho, again.drho);
}

}  // namespace spray_gate_test
}  // namespace tw
