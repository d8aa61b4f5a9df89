// Whole runs through the real interFoam, small enough for every test day.
#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "foam_test.h"

namespace tw {
namespace short_runs_test {
namespace fs = std::filesystem;

using ShortRun = FoamTest;

/// The water's front: the far side of the last voxel that holds at least a quarter of water.
double front(const RunRecord& record, const RasterFrame& frame) {
    const RasterSpec& r = record.raster;
    double x = -1e30;
    for (int k = 0; k < r.count[2]; ++k)
        for (int j = 0; j < r.count[1]; ++j)
            for (int i = 0; i < r.count[0]; ++i)
                if (frame.water[static_cast<std::size_t>((k * r.count[1] + j) * r.count[0] + i)] >= 64)
                    x = std::max(x, r.origin.x() + (i + 1) * r.voxel);
    return x;
}

TEST_F(ShortRun, ADamBreakKeepsItsWaterAndLosesOnlyTheEnergyItMay) {
    const Scene s = scene(dam_break("0.2 s"));
    const RunRecord record = run_fvm(s, options());
    EXPECT_EQ(record.state, "finished") << record.reason;
    ASSERT_EQ(record.frames.size(), 10u);
    const Table& samples = record.tables.at("samples");
    const double water = 0.146 * 0.292 * 1000;  // per metre of span
    EXPECT_EQ(samples.find("mass")->unit, "kg/m");
    for (const double mass : samples.find("mass")->values) EXPECT_NEAR(mass, water, 1e-3 * water);
    const auto &kinetic = samples.find("kinetic_energy")->values, &potential = samples.find("potential_energy")->values;
    const double potential_at_start = water * 9.81 * 0.146;
    for (std::size_t i = 0; i < kinetic.size(); ++i) EXPECT_LT(kinetic[i] + potential[i], 1.005 * potential_at_start);
    EXPECT_GT(kinetic.back(), 0.2 * potential_at_start) << "it falls";
    // Measured (Koshizuka & Oka 1996): x/a = 1.98 at t sqrt(2 g / a) = 1.62, that is 0.14 s. A voxel of the raster is
    // 0.2 a.
    EXPECT_NEAR(front(record, record.frames[6]) / 0.146, 1.98, 0.35);

    // Probes: the column is 0.292 m high at first, and sinks.
    const Table &p = record.tables.at("pressure"), &h = record.tables.at("height");
    EXPECT_GT(p.time.size(), 20u) << "probes are read every step";
    EXPECT_NEAR(h.columns[0].values.front(), 0.292, 1e-3);
    EXPECT_LT(h.columns[0].values.back(), 0.28);

    const RunRecord again = read_record(options().folder / "record.h5");
    EXPECT_EQ(again.state, "finished");
    EXPECT_EQ(again.frames.size(), record.frames.size());
    EXPECT_EQ(again.attributes.at("openfoam"), record.attributes.at("openfoam"));
    EXPECT_EQ(again.attributes.count("openfoam_self_test"), 1u);
    EXPECT_GT(again.peak_memory, 1e7);
    EXPECT_GT(again.steps, 10);
    EXPECT_EQ(again.elements, 40 * 1 * 27);
}

TEST_F(ShortRun, InATankTheCourantNumberSetsTheStepsAndSamplingDoesNot) {
    // Interval 20 ms is some steps of these cells, 5 ms less than one: split evenly between writes, it set the steps.
    const auto run = [&](const std::string& interval, double courant_factor) {
        std::ofstream(folder / "scene.toml") << dam_break("0.3 s", interval);
        RunOptions o = options();
        o.overwrite = true;
        SceneOverrides overrides;
        overrides.courant_factor = courant_factor;
        const RunRecord r = run_fvm(read_scene(folder / "scene.toml", overrides), o);
        EXPECT_EQ(r.state, "finished") << r.reason;
        return r;
    };
    const RunRecord rare = run("20 ms", 1), often = run("5 ms", 1), half = run("5 ms", 0.5);
    EXPECT_NEAR(often.steps / rare.steps, 1, 0.05) << rare.steps << " and " << often.steps << " steps";
    EXPECT_NEAR(half.steps / often.steps, 2, 0.3) << often.steps << " and " << half.steps << " steps";
    // Where steps are longer than the interval every step is a frame; else there are as many frames as intervals.
    EXPECT_EQ(rare.frames.size(), 15u);
    EXPECT_GE(double(often.frames.size()), std::min(60.0, 0.75 * often.steps));
}

TEST_F(ShortRun, WhatStandsInATankIsPressedUpByTheWaterThatItTakesThePlaceOf) {
    const RunRecord r = run_fvm(scene(R"(
[tank]
size = ["1.2 m", "20 mm", "0.5 m"]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = ["1.2 m", "20 mm", "0.3 m"]
[[obstacle]]
name = "drowned"
min = ["0.2 m", 0, "0.1 m"]
max = ["0.4 m", "20 mm", "0.2 m"]
[[obstacle]]
name = "hidden"   # in the other: the mesh has no face of it
min = ["0.26 m", 0, "0.14 m"]
max = ["0.34 m", "20 mm", "0.16 m"]
[[obstacle]]
name = "pier"
min = ["0.7 m", 0, "0.24 m"]
max = ["0.9 m", "20 mm", "0.36 m"]
[motion]
kind = "none"
[resolution]
near_hull = "20 mm"
[sampling]
interval = "20 ms"
[run]
duration = "0.1 s"
)"),
                                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const double lifted = 1000 * 9.81 * (0.2 * 0.1 + 0.2 * 0.06);  // by Archimedes [N/m]
    const Table &forces = r.tables.at("forces"), &total = r.tables.at("forces_total");
    EXPECT_EQ(forces.find("fz")->unit, "N/m");
    EXPECT_EQ(forces.time, r.tables.at("samples").time);
    EXPECT_EQ(double(total.time.size()), r.steps);
    for (const Table* t : {&forces, &total}) {
        EXPECT_NEAR(t->find("fz")->values.back(), lifted, 0.01 * lifted);
        EXPECT_NEAR(t->find("fx")->values.back(), 0, 0.01 * lifted);
    }
}

TEST_F(ShortRun, AFolderThatHoldsARunIsNotOverwrittenUnasked) {
    const Scene s = scene(dam_break("0.02 s"));
    run_fvm(s, options());
    EXPECT_THROW(run_fvm(s, options()), InputError);
    RunOptions anew = options();
    anew.overwrite = true;
    EXPECT_EQ(run_fvm(s, anew).state, "finished");
}

TEST_F(ShortRun, ATimeWithManyDigitsIsGoneOnFrom) {
    // interFoam writes 0.0401234567 s and later with more digits than it reads by default.
    const std::string interval = "0.0101234567891 s";
    RunOptions o = options();
    double reached = 0;
    o.progress = [&](const Progress& p) { reached = std::max(reached, p.time); };
    o.stop_asked = [&] { return reached > 0.05; };
    EXPECT_EQ(run_fvm(scene(dam_break("10 s", interval)), o).state, "stopped");
    RunOptions resume = options();
    resume.resume = true;
    EXPECT_EQ(run_fvm(scene(dam_break(std::to_string(reached + 0.05) + " s", interval)), resume).state, "finished");
}

TEST_F(ShortRun, StoppedRunsGoOnAndLongerDurationsTooButNotChangedScenes) {
    RunOptions o = options();
    double reached = 0;
    o.progress = [&](const Progress& p) { reached = std::max(reached, p.time); };
    o.stop_asked = [&] { return reached > 0.03; };
    const RunRecord stopped = run_fvm(scene(dam_break("10 s")), o);
    EXPECT_EQ(stopped.state, "stopped");
    EXPECT_FALSE(stopped.reason.empty());
    ASSERT_FALSE(stopped.tables.at("samples").time.empty());

    RunOptions resume = options();
    resume.resume = true;
    const double until = stopped.tables.at("samples").time.back() + 0.1;
    const RunRecord record = run_fvm(scene(dam_break(std::to_string(until) + " s")), resume);
    EXPECT_EQ(record.state, "finished") << record.reason;
    // Every write time is there once, as near as the steps come to it.
    const auto& times = record.tables.at("samples").time;
    const std::vector<double>& dt = record.tables.at("samples").find("dt")->values;
    const double longest = *std::max_element(dt.begin(), dt.end());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double apart = times[i] - (i > 0 ? times[i - 1] : 0);
        EXPECT_GT(apart, 0);
        EXPECT_LT(apart, 0.02 + 1.1 * longest);
    }
    EXPECT_EQ(record.frames.size(), times.size());
    const auto& steps = record.tables.at("pressure").time;
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
    EXPECT_EQ(record.attributes.at("restarts"), "1");

    std::string changed = dam_break("1 s");
    changed.replace(changed.find("14.6 mm\"\n[[probe"), 7, "7.30 mm");
    EXPECT_THROW(run_fvm(scene(changed), resume), InputError);
}

const char* const planing = R"(
title = "planing hull, smoke"
[hull]
shape    = "prismatic"
length   = "4 m"
beam     = "1 m"
deadrise = "20 deg"
trim     = "5 deg"
draft    = "0.2 m"
half     = true
[water]
depth = "1.5 m"
[motion]
kind  = "stream"
speed = "8 m/s"
[resolution]
near_hull = "0.08 m"
[run]
duration = "0.42 s"
[sampling]
mean_from = "0.3 s"
)";

TEST_F(ShortRun, APlaningHullIsLiftedAndItsPressureDragIsLiftTimesTheTangentOfTrim) {
    const RunRecord record = run_fvm(scene(planing), options());
    EXPECT_EQ(record.state, "finished") << record.reason;
    EXPECT_GT(record.elements, 5000);
    EXPECT_LT(record.elements, 35000);
    EXPECT_LT(record.numbers.at("hull_mesh_error"), 0.15 * 0.08);
    EXPECT_EQ(record.attributes.count("mesh_warning"), 0u);
    const Table& f = record.tables.at("forces");
    ASSERT_GT(f.time.size(), 20u);
    const auto from = static_cast<std::size_t>(std::lower_bound(f.time.begin(), f.time.end(), 0.3) - f.time.begin());
    const double lift = mean(*f.find("fz"), from), drag = mean(*f.find("fx_pressure"), from);
    // Fine meshes: 2694 to 2750 N of water on the whole hull; coarse ones 2900 to 3300 N.
    EXPECT_GT(lift, 2500);
    EXPECT_LT(lift, 3800);
    EXPECT_NEAR(drag / lift, std::tan(5 * 3.14159265 / 180), 0.25 * std::tan(5 * 3.14159265 / 180));
    EXPECT_EQ(mean(*f.find("fy"), from), 0);
    // Our own sum over the hull's faces, air included, against the solver's forces function object.
    for (std::size_t i = 3; i < f.time.size(); ++i) {
        const double total = f.find("fz_total")->values[i];
        EXPECT_NEAR(f.find("fz")->values[i] + f.find("fz_air")->values[i], total, 2e-3 * std::abs(total) + 1)
            << "t = " << f.time[i];
    }
    EXPECT_GT(mean(*f.find("fz_air"), from), 0) << "air sucks at the deck";
    const Table& samples = record.tables.at("samples");
    EXPECT_NEAR(mean(*samples.find("wetted_area"), from), 1.9, 0.5);
    EXPECT_GT(mean(*samples.find("ventilation"), from), 0);
    EXPECT_LT(mean(*samples.find("ventilation"), from), 0.5);
    // The picture: the whole hull, both halves, closed to rounding, within its bounding box.
    EXPECT_EQ(record.hull.triangles.size(), record.hull_pressure.size());
    EXPECT_NEAR(record.hull.bounds().min.y(), -record.hull.bounds().max.y(), 1e-6);
    EXPECT_NEAR(record.hull.bounds().max.y(), 0.5, 0.02);
}

// In two dimensions a hull is its section, and forces are per metre of span. Free streamlines: N = 0.8186 rho U^2 H at
// 30 degrees with the edge at -0.050201 H (tests/data/planing_plate_channel.csv). Meshes of H/12 and H/25 meet such a
// force within 3 % (docs/decisions/024-hull-force-cured.md); the bound is twice that.
TEST_F(ShortRun, AFlatPlateInAWeightlessChannelIsPressedAsFreeStreamlinesSay) {
    const RunRecord record = run_fvm(scene(R"(
[hull]
shape = "plate"
length = "3 m"
trim = "30 deg"
draft = "0.050201 m"
position = ["-1.3 m", 0]
[water]
depth = "1 m"
air_density = 0.1
[motion]
kind = "stream"
speed = "10 m/s"
[effects]
gravity = "off"
[resolution]
near_hull = "0.1 m"
[domain]
dimensions = 2
x = ["-7 m", "3 m"]
z = ["-1 m", "2.3 m"]
[run]
duration = "4 s"
[sampling]
interval = "0.2 s"
mean_from = "3.2 s"
)"),
                                     options());
    EXPECT_EQ(record.state, "finished") << record.reason;
    EXPECT_EQ(record.attributes.at("mesh_check"), "Mesh OK");
    EXPECT_LT(record.numbers.at("hull_mesh_error"), 0.15 * 0.1);
    EXPECT_EQ(record.numbers.at("gravity"), 0);
    EXPECT_LT(record.numbers.at("cell_finest"), 0.026) << "halved twice at the plate";
    const Table& f = record.tables.at("forces");
    EXPECT_EQ(f.find("fz")->unit, "N/m");
    const auto from = static_cast<std::size_t>(std::lower_bound(f.time.begin(), f.time.end(), 3.2) - f.time.begin());
    const double lift = mean(*f.find("fz"), from), drag = mean(*f.find("fx"), from);
    EXPECT_NEAR(std::hypot(lift, drag) / 1e5 / 0.818588, 1, 0.06);
    EXPECT_NEAR(drag / lift, std::tan(30 * 3.14159265 / 180), 0.01) << "normal to the plate";
    // The solver's own sum over the faces, air included, is the same force per metre.
    EXPECT_NEAR(f.find("fz_total")->values.back() / f.find("fz")->values.back(), 1, 0.01);
    EXPECT_NEAR(record.hull.bounds().size().y(), 1, 1e-9);
}

TEST_F(ShortRun, APathWithBlanksQuotesAndDollarsIsOnlyAPath) {
    RunOptions o = options();
    o.folder = folder / "a b $(touch x) \"q' #calc" / "fvm";
    const RunRecord record = run_fvm(scene(dam_break("0.02 s")), o);
    EXPECT_EQ(record.state, "finished") << record.reason;
    EXPECT_FALSE(fs::exists(folder / "x"));
}

}  // namespace short_runs_test
}  // namespace tw
