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

TEST_F(FreeHullOnAMesh, MovesByTheForcesThatAreRecordedOfItInHeaveAndPitch) {
    const RunRecord r = run_fvm(scene(planing), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table &motion = r.tables.at(hull_motion_table), &forces = r.tables.at("forces_total");
    ASSERT_EQ(motion.time.size(), forces.time.size()) << "a row each step";
    const auto of = [](const Table& t, const char* column) -> const std::vector<double>& {
        return t.find(column)->values;
    };
    const std::vector<double>&fx = of(forces, "fx"), &fz = of(forces, "fz"), &my = of(forces, "my");
    // about the centre of gravity, whose x stays; the reference lies at still water amidships
    const Vec3 centre = scene(planing).hull->free->motion.mass.centre;
    const Vec3 reference = moment_reference(scene(planing));
    double impulse = 0, turning = 0;
    // The stream starts impulsively. After that the force at the end of a step and that which moved the hull in its last
    // outer corrector still differ by a tenth; a mass of the half in place of the whole would be a factor of two.
    const auto from = static_cast<std::size_t>(std::ranges::lower_bound(motion.time, 0.03) - motion.time.begin());
    const std::size_t to = motion.time.size() - 1;
    const auto moment = [&](std::size_t i) {
        return my[i] - (of(motion, "z")[i] - reference.z()) * fx[i] + (centre.x() - reference.x()) * fz[i];
    };
    for (std::size_t i = from + 1; i <= to; ++i) {
        const double dt = motion.time[i] - motion.time[i - 1];
        impulse += dt * ((fz[i] + fz[i - 1]) / 2 - 9.81 * mass);
        turning += dt * (moment(i) + moment(i - 1)) / 2;
    }
    const double gained = mass * (of(motion, "vz")[to] - of(motion, "vz")[from]),
                 turned = mass * gyradius * gyradius * std::numbers::pi / 180 *
                          (of(motion, "trim_rate")[to] - of(motion, "trim_rate")[from]);
    EXPECT_GT(std::abs(gained), 1) << "newton seconds, or it is held";
    EXPECT_GT(std::abs(turned), 0.5) << "newton metre seconds";
    EXPECT_NEAR(impulse / gained, 1, 0.2) << "of the whole hull, half of which is solved";
    EXPECT_NEAR(turning / turned, 1, 0.2);
}

}  // namespace free_hull_test
}  // namespace tw
