#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "meshes/generate.h"
#include "on_device.h"
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/validity_checks.h"
#include "sph_solver/state/checkpoint.h"
#include "three_levels.h"

namespace tw {
namespace levels_on_device_test {

SimulationSetup stream() {
    SimulationSetup s = three_levels(1);
    s.effects.push_back(Ventilation{});
    return s;
}

::testing::AssertionResult same_levels(const Simulation& a, const Simulation& b) {
    for (std::size_t k = 0; k < a.levels().size(); ++k) {
        const Particles &p = a.level(k).fields().particles(), &q = b.level(k).fields().particles();
        if (const auto same = same_bits(p, q); !same)
            return ::testing::AssertionFailure() << "level " << k << ": " << same.message();
        const LevelLedger of_a = level_ledgers(a)[k], of_b = level_ledgers(b)[k];
        if (of_a.active != of_b.active || of_a.buffers != of_b.buffers || of_a.overlap != of_b.overlap ||
            of_a.slaves != of_b.slaves ||
            of_a.active + of_a.buffers + of_a.overlap + of_a.slaves != static_cast<std::int64_t>(q.size()))
            return ::testing::AssertionFailure() << "level " << k << " counts others";
        if (p.daughters != q.daughters || p.compression != q.compression || p.aired != q.aired)
            return ::testing::AssertionFailure() << "level " << k << " knows other children, compressions or air";
    }
    for (std::size_t k = 0; k < a.refinements().size(); ++k) {
        const Refinement::Ledger &p = a.refinements()[k].ledger(), &q = b.refinements()[k].ledger();
        if (p.splits != q.splits || p.merges != q.merges || p.spray != q.spray || p.orphans != q.orphans)
            return ::testing::AssertionFailure() << "edge " << k << " has other births, deaths, spray or orphans";
        if (a.refinements()[k].mass_drift() != b.refinements()[k].mass_drift())
            return ::testing::AssertionFailure() << "edge " << k << " has another drift of mass";
    }
    return ::testing::AssertionSuccess();
}

void expect_same_steps(Simulation& host, Simulation& device, int steps) {
    for (int k = 0; k < steps; ++k) {
        host.step(), device.step();
        ASSERT_EQ(host.dt(), device.dt()) << "step " << k;
        for (std::size_t b = 0; b < host.bodies().size(); ++b) {
            ASSERT_EQ(host.load(b).force, device.load(b).force) << "step " << k;
            ASSERT_EQ(host.load(b).moment, device.load(b).moment) << "step " << k;
        }
    }
    EXPECT_TRUE(same_levels(host, device));
}

TEST_F(OnDevice, ThreeSizesOfParticlesInAStreamMeetAsOnTheHost) {
    const SimulationSetup s = stream();
    Simulation host(s, water_of_stream(s), emulated()), device(s, water_of_stream(s), emulated());
    put_on_device(device);
    expect_same_steps(host, device, 30);
    for (const Refinement& edge : device.refinements()) {
        EXPECT_GT(edge.ledger().splits, 0);
        EXPECT_GT(edge.ledger().merges, 0);
    }
    EXPECT_GT(device.load().force.norm(), 0);
    PointSamples at_host, at_device;
    at_host.places = at_device.places = {Vec3(-0.11, 0, -0.05), Vec3(-0.8, 0, -0.5), Vec3(1.8, 0, -1.2)};
    host.sample(at_host), device.sample(at_device);
    for (std::size_t n = 0; n < at_host.p.size(); ++n) {
        EXPECT_NEAR(at_host.p[n], at_device.p[n], 1e-5 * std::abs(at_host.p[n])) << n;
        EXPECT_NEAR(at_host.support[n], at_device.support[n], 1e-6) << n;
        EXPECT_GT(at_device.support[n], 0.5) << n;
    }
}

TEST_F(OnDevice, WhereSizesMeetFewParticlesTravel) {
    const SimulationSetup s = stream();
    Simulation run(s, water_of_stream(s), emulated());
    const auto device = put_on_device(run);
    run.step();  // takes all there
    std::int64_t particles = 0;
    for (const auto& level : run.levels()) particles += level->fields().count();
    const cuda::Device::Traffic from = device->traffic();
    constexpr int steps = 29;
    RunRecord record;
    for (int k = 0; k < steps; ++k) {
        run.step();
        watch_stability(run, record);  // as a run does
    }
    const cuda::Device::Traffic to = device->traffic();
    const double bytes = double(to.to_device - from.to_device) + double(to.to_host - from.to_host);
    std::printf("%.1f bytes a particle and step between host and device\n", bytes / steps / double(particles));
    EXPECT_LT(bytes / steps, 24 * double(particles));  // places alone would be that
    for (const Refinement& edge : run.refinements()) EXPECT_GT(edge.ledger().splits, 0);
}

TEST_F(OnDevice, AColumnSurgesAcrossTheEdgeOfAZoneInThreeDimensions) {
    SimulationSetup s;
    s.dp = 0.025;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.bodies = {box_surface({Vec3(0.6, -0.4, -0.3), Vec3(0.8, 0.7, 0.15)})};
    s.zones = {zone_between(0.4, infinite, -infinite, infinite)};
    s.threads = 1;
    const std::vector<Fluid> water = fill_levels(s, {Box{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}});
    Simulation host(s, water, emulated()), device(s, water, emulated());
    put_on_device(device);
    const auto surge = [&](float u) {
        for (Simulation* run : {&host, &device})
            for (std::size_t k = 0; k < 2; ++k) std::ranges::fill(run->level(k).fields_to_set().u, u);
        expect_same_steps(host, device, 30);
        return device.refinements()[0].ledger().splits;
    };
    const std::int64_t first = surge(2);
    EXPECT_GT(first, 0);
    surge(-2);
    EXPECT_GT(std::ranges::count(device.level(0).fields().particles().daughters, Daughters::some), 0);
    EXPECT_GT(surge(2), first);  // of parents some of whose daughters are there
}

TEST_F(OnDevice, SprayEndsInWaterOfAnyCoarserSize) {
    const SimulationSetup s = stream();
    Simulation host(s, water_of_stream(s), emulated()), device(s, water_of_stream(s), emulated());
    put_on_device(device);
    std::int64_t drop = 0;
    for (Simulation* run : {&host, &device}) {
        Particles p = run->finest().fields().particles();
        drop = p.id[0];
        p.kind[0] = Kind::fluid;
        p.x[0] = -1.8, p.z[0] = 0.1, p.u[0] = 0, p.w[0] = -2;  // beyond the zone of the next coarser size
        run->finest().restore(run->finest().state(), std::move(p));
    }
    const auto there = [&](const Simulation& run) {
        return std::ranges::count(run.finest().fields().particles().id, drop);
    };
    expect_same_steps(host, device, 4);
    EXPECT_EQ(there(device), 1);
    expect_same_steps(host, device, 30);
    EXPECT_EQ(there(device), 0);
}

/// A box that falls into water at rest, with a zone that goes with it.
TEST_F(OnDevice, AZoneGoesWithABodyThatFalls) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.025;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    BodySetup falls = box_surface({Vec3(-0.1, -1, -0.05), Vec3(0.1, 1, 0.15)});
    falls.moving.emplace();
    falls.moving->mass = solid_mass(falls.surface, 700);
    falls.moving->velocity = Vec3(0, 0, -2);
    s.bodies = {falls};
    s.zones_round = [](std::span<const MovedSolid> moving) {
        const Box& b = moving.front().bounds;
        return std::vector{zone_between(b.min.x() - 0.3, b.max.x() + 0.3, b.min.z() - 0.3, b.max.z() + 0.3)};
    };
    s.zones = s.zones_round(std::vector<MovedSolid>{Body::of(s.bodies[0])->moved()});
    s.threads = 1;
    const std::vector<Fluid> water = fill_levels(s, {Box{Vec3(-1, -1, -1), Vec3(1, 1, 0)}});
    Simulation host(s, water, emulated()), device(s, water, emulated());
    put_on_device(device);
    expect_same_steps(host, device, 60);
    EXPECT_EQ(host.body(0).state(), device.body(0).state());
    EXPECT_GT(device.refinements()[0].ledger().splits, 0);
}

TEST_F(OnDevice, AZoneThatGetsAnotherPartIsFoundAnew) {
    const auto tank = [] {
        SimulationSetup s;
        s.dimensions = 2;
        s.dp = 0.025;
        s.state_equation.c0 = 30;
        s.domain = {Vec3(-1, -1, -0.8), Vec3(1, 1, 0.8)};
        s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
        s.zones = {zone_between(-infinite, -0.5, -infinite, infinite)};
        s.zones_round = [start = s.zones.front(), calls = std::make_shared<int>(0)](std::span<const MovedSolid>) {
            std::vector<Box> boxes = start.boxes();
            if (++*calls > 6) boxes.push_back({Vec3(0.4, -infinite, -0.5), Vec3(0.8, infinite, infinite)});
            return std::vector{Zone(boxes)};
        };
        s.threads = 1;
        return s;
    };
    const std::vector<Fluid> water = fill_levels(tank(), {Box{Vec3(-1, -1, -0.8), Vec3(1, 1, 0)}});
    Simulation host(tank(), water, emulated()), device(tank(), water, emulated());
    put_on_device(device);
    expect_same_steps(host, device, 15);
    EXPECT_GT(device.refinements()[0].ledger().splits, 300);  // the new part's
}

TEST_F(OnDevice, ACheckpointOfSeveralSizesGoesFromTheHostToADeviceAndBack) {
    const auto file = std::filesystem::temp_directory_path() / "levels_on_device_test.h5";
    const SimulationSetup s = stream();
    Simulation whole(s, water_of_stream(s), emulated());
    for (int k = 0; k < 8; ++k) whole.step();
    const auto hand_over = [&](const Simulation& from, Simulation& to) {
        write_checkpoint(file, "a scene", checkpoint_of(from, 1));
        whole.mark_restart_point();
        restore(to, read_checkpoint(file, "a scene"));
        for (int k = 0; k < 8; ++k) whole.step(), to.step();
        EXPECT_TRUE(same_levels(whole, to));
    };
    Simulation device(s, water_of_stream(s), emulated()), back(s, water_of_stream(s), emulated());
    put_on_device(device);
    hand_over(whole, device);
    hand_over(device, back);
    std::filesystem::remove(file);
}

}  // namespace levels_on_device_test
}  // namespace tw
