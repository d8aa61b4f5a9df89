// Levels of particle size: interpolation between them, who is what at their edge, and the promises that a run keeps
// with them (the same bits with any number of threads and after a restart).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "base/numbers.h"
#include "meshes/generate.h"
#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"
#include "system_to_change.h"
#include "three_levels.h"

namespace tw {
namespace levels_test {

TEST(Zones, TellTheDistanceFromTheirEdgeOnBothSides) {
    const Zone open_above = zone_between(0, 2, -1, infinite);
    EXPECT_DOUBLE_EQ(open_above.outside(Vec3(1, 5, 0)), -1);
    EXPECT_DOUBLE_EQ(open_above.outside(Vec3(0.25, 0, 9)), -0.25);
    EXPECT_DOUBLE_EQ(open_above.outside(Vec3(-0.3, 0, -1.4)), 0.5);  // from the corner
    const Zone two({Box{Vec3(0, 0, 0), Vec3(1, 1, 1)}, Box{Vec3(3, 0, 0), Vec3(4, 1, 1)}});
    EXPECT_DOUBLE_EQ(two.outside(Vec3(2.25, 0.5, 0.5)), 0.75);
}

/// Water in a closed box in which the velocity and the density are linear in space.
Simulation linear_water(int dimensions, bool with_surface) {
    SimulationSetup s;
    s.dimensions = dimensions;
    s.dp = 0.1;
    s.state_equation.c0 = 20;
    s.gravity = Vec3::Zero();
    s.threads = 1;
    s.domain = {Vec3(0, dimensions == 2 ? -1 : 0, 0), Vec3(1.6, dimensions == 2 ? 1 : 1.6, 1.6)};
    Box water = s.domain;
    if (with_surface) water.max.z() = 0.8;
    Fluid fluid = fill_with_fluid(s, {water});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.03, 0.03);
    for (Vec3& x : fluid.places)
        for (int a = 0; a < 3; ++a)
            if (a != 1 || dimensions == 3) x[a] += shift(random);
    for (double& depth : fluid.depth) depth = 0;
    Simulation simulation(s, fluid);
    simulation.step();
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = static_cast<float>(1 + 2 * p.x[i] - p.z[i]);
        p.v[i] = static_cast<float>(dimensions == 3 ? p.y[i] : 0);
        p.w[i] = static_cast<float>(3 * p.z[i] - 0.5);
        p.drho[i] = static_cast<float>(0.4 * p.x[i] - 0.7 * p.z[i]);
    }
    return simulation;
}

TEST(Interpolation, IsExactForLinearFieldsInsideAtTheSurfaceAndInCorners) {
    for (const int dimensions : {2, 3})
        for (const bool surface : {false, true}) {
            Simulation simulation = linear_water(dimensions, surface);
            FieldsAt at;
            const double top = surface ? 0.79 : 1.55;
            for (const double x : {0.04, 0.33, 0.8, 1.56})
                for (const double z : {0.04, 0.4, top}) at.places.emplace_back(x, dimensions == 2 ? 0 : 0.77, z);
            simulation.level(0).fields().interpolate(at);
            for (std::size_t k = 0; k < at.places.size(); ++k) {
                const Vec3& x = at.places[k];
                EXPECT_NEAR(at.value[k].u, 1 + 2 * x.x() - x.z(), 2e-5) << dimensions << surface << x.transpose();
                EXPECT_NEAR(at.value[k].w, 3 * x.z() - 0.5, 2e-5) << x.transpose();
                EXPECT_NEAR(at.value[k].drho, 0.4 * x.x() - 0.7 * x.z(), 2e-5) << x.transpose();
                EXPECT_GT(at.support[k], 0.2) << x.transpose();
            }
        }
}

// A zone that the water is just coming to holds buffer particles alone.
TEST(Interpolation, FromNothingThatCountsIsNothing) {
    Simulation simulation = linear_water(2, true);
    for (Kind& kind : system_to_change(simulation.level(0)).particles.kind) kind = Kind::buffer;
    FieldsAt at;
    at.places = {Vec3(0.8, 0, 0.4), Vec3(0.33, 0, 0.4)};
    at.want_compression = true;
    at.of = Giving::not_buffers;
    simulation.level(0).fields().interpolate(at);
    ASSERT_EQ(at.compression.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(at.support[k], 0);
        EXPECT_EQ(at.compression[k], 0);
    }
}
Simulation make(int threads) {
    const SimulationSetup s = three_levels(threads);
    return Simulation(s, water_of_stream(s));
}

/// The same stream in a wider and deeper box, four sizes of particles: two zones beside each other in the second.
Simulation four_levels(int threads) {
    SimulationSetup s = three_levels(threads);
    s.domain = {Vec3(-4.48, -1, -3.2), Vec3(4.48, 1, 1.6)};
    s.stream = Stream{1, 0.1, 6 * 0.16};
    const Zone wide = zone_between(-2.88, 2.88, -1.92, infinite);
    const Box beside{Vec3(1.92, -infinite, -0.96), Vec3(2.4, infinite, infinite)};
    s.zones.insert(s.zones.begin(), wide);
    s.zones[1] = Zone({s.zones[1].boxes().front(), beside});
    const Box water{Vec3(-4.48 - s.stream->buffer, -1, -3.2), Vec3(4.48 + s.stream->buffer, 1, 0)};
    return Simulation(s, fill_levels(s, {water}));
}

::testing::AssertionResult same_bits(const Simulation& a, const Simulation& b) {
    for (std::size_t k = 0; k < a.levels().size(); ++k) {
        const Particles &p = a.level(k).fields().particles(), &q = b.level(k).fields().particles();
        if (p.id != q.id || p.x != q.x || p.z != q.z || p.u != q.u || p.w != q.w || p.drho != q.drho ||
            p.kind != q.kind || p.daughters != q.daughters)
            return ::testing::AssertionFailure() << "level " << k << " differs";
    }
    return ::testing::AssertionSuccess();
}

// The formula's pressure of the uppermost row against a tank at rest, where sound is averaged out.
TEST(SurfaceExcess, IsThatOfATankAtRest) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.04;
    s.state_equation.c0 = 10 * std::sqrt(9.81);
    s.domain = {Vec3(0, -1, -1), Vec3(0.4, 1, 1)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.mirrors.periodic = {true, false, false};
    Simulation tank(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(0.4, 1, 0)}}));
    const double row = s.rho0 * 9.81 * s.dp;
    double top = 0, fifth = 0;
    int n = 0;
    while (tank.time() < 1.5) {
        tank.step();
        if (tank.time() < 0.5) continue;
        const Particles& p = tank.particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double above = tank.level(0).fields().pressure(i) + s.rho0 * 9.81 * p.z[i];
            if (p.z[i] > -s.dp) top += above / row, ++n;
            if (std::abs(p.z[i] + 4.5 * s.dp) < s.dp / 2) fifth += above / row;
        }
    }
    const SurfaceExcess excess(tank.level(0).system().kernel, s.dp, 2);
    EXPECT_NEAR((top - fifth) / n, excess.uppermost(), 0.06);
    EXPECT_DOUBLE_EQ(excess.of(1), 0);
    EXPECT_DOUBLE_EQ(excess.of(0.3), excess.uppermost());
}

TEST(Levels, StartWithOneOwnerForEveryPlace) {
    const Simulation simulation = make(1);
    double mass = 0;
    for (const auto& level : simulation.water())
        for (const Kind kind : level->fields().particles().kind) mass += is_active(kind) ? level->system().mass : 0;
    const double buffers = 2 * 6 * 0.08;
    EXPECT_NEAR(mass, 1000 * ((4.8 + buffers) * 1.6 - 0.2 * 0.1), 1e-6 * mass);
    EXPECT_EQ(simulation.refinements().size(), 2u);
}

TEST(Levels, TheCoarsestKeepsItsMassButForInletAndOutlet) {
    Simulation simulation = make(2);
    const auto before = static_cast<std::int64_t>(simulation.particles().size());
    for (int k = 0; k < 60; ++k) simulation.step();
    EXPECT_GT(simulation.refinements()[1].ledger().splits, 0);
    EXPECT_GT(simulation.refinements()[1].ledger().merges, 0);
    const Ledger& l = simulation.ledger();
    EXPECT_EQ(static_cast<std::int64_t>(simulation.particles().size()), before + l.in - l.out);
    EXPECT_DOUBLE_EQ(simulation.level(1).system().time, simulation.time());  // two steps of each for one of the coarser
    EXPECT_NEAR(simulation.level(2).system().time, simulation.time(), 1e-12);
    EXPECT_EQ(simulation.level(2).system().steps, 4 * simulation.steps());
}

// Spray of the finest size that flies farther than the zone of the next one comes down on water of a size that is no
// neighbour of its own. It ends there, as spray over the next size does, and does not fall through to the floor.
TEST(Levels, FineSprayEndsInWaterOfAnyCoarserSize) {
    Simulation simulation = make(1);
    Particles& p = system_to_change(simulation.finest()).particles;
    const std::int64_t id = p.id[0];
    const auto drop = [&] { return std::ranges::find(p.id, id); };
    p.kind[0] = Kind::fluid;
    p.x[0] = -1.8, p.z[0] = 0.3, p.u[0] = 0, p.w[0] = -2;
    double lowest = 0.3;
    while (simulation.time() < 0.5 && drop() != p.id.end()) {
        simulation.step();
        if (const auto at = drop(); at != p.id.end())
            lowest = std::min(lowest, p.z[static_cast<std::size_t>(at - p.id.begin())]);
    }
    EXPECT_EQ(drop(), p.id.end());
    EXPECT_LT(lowest, 0.15);
    EXPECT_GT(lowest, -0.2);  // 2.5 of the coarsest spacings
}

// A zone that goes on through the outlet: what stands beyond it is nobody's mass.
TEST(Levels, AZoneThroughTheOutletKeepsItsMass) {
    SimulationSetup s = three_levels(1);
    s.bodies.clear();
    s.zones = {zone_between(-1.2, infinite, -0.96, infinite), zone_between(-0.48, infinite, -0.4, infinite)};
    Simulation simulation(s, water_of_stream(s));
    while (simulation.time() < 0.8) simulation.step();  // farther than the buffer is long
    // three coarse columns
    for (const Refinement& edge : simulation.refinements()) EXPECT_NEAR(edge.mass_drift(), 0, 0.045);
}

/// Two runs of `make` with other numbers of threads, one of them begun anew in the middle.
void expect_same_bits_after_a_restart(Simulation (*make_with)(int threads), int steps) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "restart_levels_test.h5";
    Simulation whole = make_with(1), other = make_with(3);
    for (int k = 0; k < steps; ++k) whole.step(), other.step();
    EXPECT_TRUE(same_bits(whole, other));
    write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
    whole.mark_restart_point();
    Simulation resumed = make_with(2);
    restore(resumed, read_checkpoint(file, "a scene"));
    for (int k = 0; k < steps; ++k) whole.step(), resumed.step();
    EXPECT_TRUE(same_bits(whole, resumed));
    EXPECT_EQ(whole.load().force, resumed.load().force);
    EXPECT_GT(whole.load().force.norm(), 0);
    for (std::size_t k = 0; k < whole.refinements().size(); ++k) {
        const Refinement &a = whole.refinements()[k], &b = resumed.refinements()[k];
        EXPECT_GT(a.ledger().splits, 0) << k;
        EXPECT_EQ(a.ledger().splits, b.ledger().splits) << k;
        EXPECT_EQ(a.ledger().merges, b.ledger().merges) << k;
        EXPECT_EQ(a.ledger().orphans, b.ledger().orphans) << k;
        EXPECT_EQ(a.mass_drift(), b.mass_drift()) << k;
    }
}

TEST(Levels, AnyNumberOfThreadsAndARestartGiveTheSameBits) { expect_same_bits_after_a_restart(make, 25); }

TEST(Levels, FourSizesWithTwoZonesOfOneKeepTheirBitsToo) { expect_same_bits_after_a_restart(four_levels, 12); }

}  // namespace levels_test
}  // namespace tw
