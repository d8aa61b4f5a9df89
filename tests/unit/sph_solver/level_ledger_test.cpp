// What a run with several sizes of particles tells of each of them.
#include "sph_solver/measure/level_ledger.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "record/recorded_checks.h"
#include "sph_solver/measure/zone_mass.h"
#include "sph_solver/run_sph.h"
#include "system_to_change.h"

namespace tw {
namespace level_ledger_test {

/// Weightless water, 0.8 m high and periodic along x, that streams through a zone of half the spacing.
Simulation stream_through_a_zone(double air_above = 0) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.01;
    s.state_equation.c0 = 10;
    s.gravity = Vec3::Zero();
    const Box water_in{Vec3(0, -1, 0), Vec3(1.2, 1, 0.8)};
    s.domain = {water_in.min, water_in.max + Vec3(0, 0, air_above)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.mirrors.periodic = {true, false, false};
    s.zones = {Zone({Box{Vec3(0.4, -infinite, 0.2), Vec3(0.8, infinite, 0.6)}})};
    std::vector<Fluid> water = fill_levels(s, {water_in});
    for (Fluid& fluid : water) fluid.depth.assign(fluid.depth.size(), 0);
    Simulation simulation(s, water);
    for (const auto& level : simulation.levels()) std::ranges::fill(level->fields_to_set().u, 1.0f);
    return simulation;
}

TEST(LevelLedger, CountsEveryParticleOnceAndBalancesBirthsAndDeaths) {
    Simulation simulation = stream_through_a_zone();
    const std::size_t at_start = simulation.level(1).fields().particles().size();
    for (int k = 0; k < 30; ++k) simulation.step();
    for (std::size_t k = 0; k < 2; ++k) {
        const LevelLedger l = level_ledgers(simulation)[k];
        EXPECT_EQ(l.active + l.buffers + l.overlap + l.slaves,
                  static_cast<std::int64_t>(simulation.level(k).fields().particles().size()));
        EXPECT_EQ(l.buffers > 0, k == 1);
        EXPECT_EQ(l.overlap + l.slaves > 0, k == 0);
    }
    const std::vector<LevelLedger> sizes = level_ledgers(simulation);
    const LevelLedger &coarse = sizes[0], &fine = sizes[1];
    EXPECT_EQ(fine.dt, coarse.dt / 2);
    EXPECT_EQ(fine.spacing, coarse.spacing / 2);
    ASSERT_GT(fine.edge.splits, 0);
    ASSERT_GT(fine.edge.merges, 0);
    EXPECT_EQ(static_cast<std::int64_t>(simulation.level(1).fields().particles().size()),
              static_cast<std::int64_t>(at_start) + fine.edge.splits - fine.edge.merges);
}

// A zone of 20 x 20 coarse particles that loses eight fine ones, two coarse ones' mass, has lost 1/200 of its mass.
TEST(LevelLedger, MassThatAZoneLosesIsTold) {
    Simulation simulation = stream_through_a_zone();
    EXPECT_EQ(level_ledgers(simulation)[1].mass_drift, 0);
    int taken = 0;
    for (Kind& kind : system_to_change(simulation.level(1)).particles.kind)
        if (kind == Kind::fluid && taken < 8) kind = Kind::buffer, ++taken;
    EXPECT_NEAR(level_ledgers(simulation)[1].mass_drift, -1.0 / 200, 1e-12);
    // Where that stays so, the record says so; two steps without the rows that are on their way are no loss.
    const auto checked = [&](int frames_with_loss) {
        ZoneMass mass;
        RunRecord record;
        Table& table = record.table(level_table(1));
        std::vector<LevelLedger> sizes = level_ledgers(simulation), whole = sizes;
        whole[1].mass_drift = 0;
        for (int frame = 0; frame < 20; ++frame) {
            for (int step = 0; step < 3; ++step) mass.add(frame < frames_with_loss ? sizes : whole);
            table.set(table.append(frame), "mass_drift", "%", 100 * mass.take_mean(1));
            check_zone_mass(table, record);
        }
        EXPECT_EQ(mass.take_mean(1), 0);  // no step since
        const auto line = std::ranges::find(record.validity_checks, mass_drift_line, &RecordedCheck::name);
        EXPECT_TRUE(only_warns(*line));
        return *line;
    };
    EXPECT_NEAR(checked(20).value, 0.5, 1e-9);
    EXPECT_EQ(checked(20).time, 7);
    EXPECT_NEAR(checked(2).value, 0.125, 1e-9);
}

// Fine particles that fly beyond the zone, where there is no coarse water, are spray and no longer the zone's water.
TEST(LevelLedger, SprayBeyondAZoneIsNotCountedAsItsWater) {
    Simulation simulation = stream_through_a_zone(1);
    const FieldsToSet p = simulation.level(1).fields_to_set();
    std::int64_t flying = 0;
    for (std::size_t i = 0; i < p.size() && flying < 8; ++i)
        if (p.kind[i] == Kind::fluid) p.z[i] = 1.2 + 0.01 * double(flying++);
    simulation.step();
    const LevelLedger l = level_ledgers(simulation)[1];
    EXPECT_EQ(l.edge.spray, 8);
    EXPECT_NEAR(l.mass_drift, -1.0 / 200, 1e-12);
}

/// A short run of a planing prism.
RunRecord prism_run(int levels, const std::filesystem::path& folder) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << R"(
[hull]
shape = "prismatic"
length = "4 m"
beam = "1 m"
deadrise = "20 deg"
trim = "5 deg"
draft = "0.2 m"
half = true
[motion]
speed = "8 m/s"
ramp = "0.15 s"
[resolution]
near_hull = "0.2 m"
[domain]
x = ["-9.6 m", "6.4 m"]
y = ["-2.4 m", "2.4 m"]
z = ["-3.2 m", "2.4 m"]
[run]
duration = "0.01 s"
[sampling]
interval = "0.005 s"
[sph]
zone = 8
levels = )" << levels << "\n";
    RunOptions options;
    options.folder = folder / "sph";
    options.threads = 1;
    run_sph(read_scene(folder / "scene.toml"), options);
    return read_record(options.folder / "record.h5");
}

TEST(LevelLedger, StandsInTheRecordAtEveryFrameWithTheZonesOfTheEnd) {
    const auto folder = std::filesystem::temp_directory_path() / "level_ledger_test";
    const RunRecord two = prism_run(2, folder), one = prism_run(1, folder);
    for (const std::size_t k : {0u, 1u}) {
        const Table& t = two.tables.at(level_table(k));
        EXPECT_EQ(t.time, two.tables.at("samples").time);
        EXPECT_EQ(t.find("spacing")->values.back(), k == 0 ? 0.4 : 0.2);
        EXPECT_EQ(t.find("guards") != nullptr, k == 1);  // the coarsest has no edge
        EXPECT_EQ(t.find("carried") != nullptr, k == 0);
    }
    const auto active = [&](std::size_t k) { return two.series(level_table(k), "active")->values.back(); };
    EXPECT_EQ(two.series("samples", "particles")->values.back(), active(0) + active(1));
    ASSERT_GE(two.resolution.size(), 2u);  // the zone follows the hull, piece by piece
    EXPECT_EQ(two.resolution[0].size, 0.4);
    for (std::size_t k = 1; k < two.resolution.size(); ++k) {
        EXPECT_EQ(two.resolution[k].size, 0.2);
        EXPECT_EQ(two.resolution[k].box.max.z(), two.resolution[0].box.max.z());  // through the sky
    }
    EXPECT_FALSE(one.tables.contains(level_table(0)));
    EXPECT_EQ(one.resolution.size(), 1u);
    const auto has_line = [](const RunRecord& r, const char* name) {
        return std::ranges::find(r.validity_checks, name, &RecordedCheck::name) != r.validity_checks.end();
    };
    for (const char* line : {mass_drift_line, orphans_line}) {
        EXPECT_TRUE(has_line(two, line)) << line;
        EXPECT_FALSE(has_line(one, line)) << line;
    }
    std::filesystem::remove_all(folder);
}

}  // namespace level_ledger_test
}  // namespace tw
