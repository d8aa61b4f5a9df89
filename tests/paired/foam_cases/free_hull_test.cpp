// A hull that is free in a stream, through the real interFoam.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "foam_test.h"
#include "record/hull_motion.h"
#include "scene/new_record.h"

namespace tw {
namespace free_hull_test {

using FreeHullOnAMesh = FoamTest;

constexpr double mass = 40, gyradius = 0.5;
const std::string planing = R"(
[hull]
shape    = "prismatic"
length   = "2 m"
beam     = "0.5 m"
deadrise = "20 deg"
trim     = "5 deg"
draft    = "0.1 m"
half     = true
free     = ["heave", "pitch"]
mass     = "40 kg"
lcg      = "0.5 m"
vcg      = "0.15 m"
pitch_gyradius = "0.5 m"
[motion]
kind  = "stream"
speed = "5 m/s"
[domain]
ahead  = "0.5 m"
behind = "0.5 m"
side   = "0.7 m"
below  = "0.5 m"
[resolution]
near_hull = "0.0625 m"
[run]
duration = "0.2 s"
methods  = ["fvm"]
[fvm]
max_courant       = 1
max_alpha_courant = 1
)";

/// It with keys of its hull added.
std::string planing_with(const std::string& keys) {
    std::string text = planing;
    return text.insert(text.find("[motion]"), keys + "\n");
}

const std::vector<double>& of(const Table& t, const char* column) { return t.find(column)->values; }

/// What the forces in the record give the whole hull from a time on, over the momentum that it gains.
struct Gains {
    double up, about;  ///< gained [N s, N m s]
    double force_over_up, moment_over_about;
};

Gains gains_from(const RunRecord& r, const Scene& s, double begin) {
    const Table &motion = r.tables.at(hull_motion_table), &forces = r.tables.at("forces_total");
    const std::vector<double>&fx = of(forces, "fx"), &fz = of(forces, "fz"), &my = of(forces, "my");
    // about the centre of gravity, whose x stays; the reference lies at still water amidships
    const Vec3 centre = s.hull->free->motion.mass.centre, reference = moment_reference(s);
    const auto from = static_cast<std::size_t>(std::ranges::lower_bound(motion.time, begin) - motion.time.begin());
    const std::size_t to = motion.time.size() - 1;
    const auto moment = [&](std::size_t i) {
        return my[i] - (of(motion, "z")[i] - reference.z()) * fx[i] + (centre.x() - reference.x()) * fz[i];
    };
    double impulse = 0, turning = 0;
    for (std::size_t i = from + 1; i <= to; ++i) {
        const double dt = motion.time[i] - motion.time[i - 1];
        impulse += dt * ((fz[i] + fz[i - 1]) / 2 - 9.81 * mass);
        turning += dt * (moment(i) + moment(i - 1)) / 2;
    }
    const double up = mass * (of(motion, "vz")[to] - of(motion, "vz")[from]),
                 about = mass * gyradius * gyradius * std::numbers::pi / 180 *
                         (of(motion, "trim_rate")[to] - of(motion, "trim_rate")[from]);
    return {up, about, impulse / up, turning / about};
}

TEST_F(FreeHullOnAMesh, MovesByTheForcesThatAreRecordedOfItInHeaveAndPitch) {
    const Scene s = scene(planing_with("release = 0"));
    const RunRecord r = run_fvm(s, options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    ASSERT_EQ(r.tables.at(hull_motion_table).time.size(), r.tables.at("forces_total").time.size()) << "a row each step";
    // The stream starts impulsively. After that the force at the end of a step and that which moved the hull in its last
    // outer corrector still differ by a tenth; a mass of the half in place of the whole would be a factor of two.
    const Gains g = gains_from(r, s, 0.03);
    EXPECT_GT(std::abs(g.up), 1) << "newton seconds, or it is held";
    EXPECT_GT(std::abs(g.about), 0.5) << "newton metre seconds";
    EXPECT_NEAR(g.force_over_up, 1, 0.2) << "of the whole hull, half of which is solved";
    EXPECT_NEAR(g.moment_over_about, 1, 0.2);
}

// Also where the run is stopped before the release and goes on, on two cores.
TEST_F(FreeHullOnAMesh, StandsStillUntilItsReleaseAndThenMovesByTheForces) {
    if (sound_openfoam().hold_library.empty())
        GTEST_SKIP() << "no library that holds hulls: twinwake setup-openfoam builds it";
    constexpr double release = 0.1;
    const Scene s = scene(planing_with("release = \"0.1 s\"") + "[sampling]\ninterval = \"10 ms\"\n");
    RunOptions first = options();
    first.threads = 2;
    double reached = 0;
    first.progress = [&](const Progress& p) { reached = std::max(reached, p.time); };
    first.stop_asked = [&] { return reached > 0.02; };
    const RunRecord stopped = run_fvm(s, first);
    ASSERT_EQ(stopped.state, "stopped") << stopped.reason;
    ASSERT_LT(stopped.tables.at(hull_motion_table).time.back(), release) << "or this test sees half of it";
    RunOptions second = options();
    second.threads = 2;
    second.resume = true;
    const RunRecord r = run_fvm(s, second);
    ASSERT_EQ(r.state, "finished") << r.reason;
    EXPECT_EQ(r.attributes.at("hull_release"), "the hull is held until its release");
    const Table& motion = r.tables.at(hull_motion_table);
    std::size_t held = 0;
    double moved = 0, fastest = 0;  // [m or degrees], [m/s or degrees/s]
    for (; held < motion.time.size() && motion.time[held] <= release; ++held) {
        for (const char* place : {"z", "trim"})
            moved = std::max(moved, std::abs(of(motion, place)[held] - of(motion, place)[0]));
        for (const char* speed : {"vz", "trim_rate"}) fastest = std::max(fastest, std::abs(of(motion, speed)[held]));
    }
    EXPECT_LT(moved, 1e-9);
    EXPECT_LT(fastest, 1e-9);
    EXPECT_GT(held, 10u);
    EXPECT_NEAR(of(motion, "trim")[0], 5, 1e-6);
    const Gains g = gains_from(r, s, release);
    EXPECT_GT(std::abs(g.up), 1) << "newton seconds, or it is held for ever";
    EXPECT_NEAR(g.force_over_up, 1, 0.2);
    EXPECT_NEAR(g.moment_over_about, 1, 0.2);
}

/// A ship with the stream started at once round it in steps of 0.9 ms and less: the water behind its middle is under tension
/// for a moment, and faces open. Openings that start from rest in each step draw ever harder at the water beside them: 1000
/// m/s after 0.0135 s of a free hull, 0.0155 s of a held one.
std::string steep_sides(const std::string& keys) {
    return R"(
[hull]
shape          = "wigley"
length         = "3 m"
beam           = "0.3 m"
design_depth   = "0.1875 m"
freeboard      = "0.15 m"
fullness       = 0.2
draft          = "0.1875 m"
half           = true
)" + keys + R"([motion]
kind  = "stream"
speed = "1.6275 m/s"
[domain]
ahead  = "0.6 m"
behind = "0.6 m"
side   = "0.6 m"
below  = "0.6 m"
above  = "0.35 m"
[resolution]
near_hull = "0.0375 m"
[effects]
forcing_zones = "off"
[sampling]
interval = "10 ms"
[run]
duration = "0.03 s"
methods  = ["fvm"]
[fvm]
max_courant       = 0.1
max_alpha_courant = 0.1
)";
}
constexpr double shortest_step = 3e-4;  // water that is drawn ever faster has ever shorter ones

TEST_F(FreeHullOnAMesh, OfSteepSidesLetsWaterGoInShortStepsToo) {
    if (sound_openfoam().wall_library.empty()) GTEST_SKIP() << "no library of walls: twinwake setup-openfoam builds it";
    const std::string keys =
        "free = [\"heave\", \"pitch\"]\nmass = 78\nlcg = 1.5\nvcg = 0.17\npitch_gyradius = "
        "0.75\nrelease = 0.012\n";
    const RunRecord r = run_fvm(scene(steep_sides(keys)), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    EXPECT_GT(of(r.tables.at("samples"), "dt").back(), shortest_step);
}

using HeldHullOnAMesh = FoamTest;

TEST_F(HeldHullOnAMesh, OfSteepSidesLetsWaterGoInShortStepsToo) {
    if (sound_openfoam().wall_library.empty()) GTEST_SKIP() << "no library of walls: twinwake setup-openfoam builds it";
    const RunRecord r = run_fvm(scene(steep_sides("")), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    EXPECT_GT(of(r.tables.at("samples"), "dt").back(), shortest_step);
}

}  // namespace free_hull_test
}  // namespace tw
