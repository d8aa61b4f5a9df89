#include "scene/defaults.h"
#include "scene/hash.h"
#include "scene_text.h"

namespace tw::test {
namespace tank_motion_test {

const std::string swaying = R"([tank]
min = [-0.5, 0, -0.2]
max = [0.5, 0.01, 0.3]
law = "sinusoid"
along = [1, 0, 0]
amplitude = 0.02
period = 1.5
[domain]
dimensions = 2
[resolution]
near_hull = 0.01
)";
const std::string rolling =
    with(with(swaying, "along = [1, 0, 0]", "about = [0, 1, 0]"), "period", "phase = \"90 deg\"\nperiod");

void expect_complaint(const std::string& text, const std::string& part) {
    const std::string message = complaint(text);
    EXPECT_NE(message.find(part), std::string::npos) << "found: " << message;
    EXPECT_EQ(message.rfind("scene.toml:", 0), 0u) << message;
}

TEST(TankMotion, IsReadAsABodysIs) {
    const Scene sway = scene_of(swaying);
    ASSERT_TRUE(sway.tank_motion);
    EXPECT_FALSE(sway.tank_motion->law.turns);
    EXPECT_EQ(sway.tank_motion->law.amplitude, 0.02);
    const Scene roll = scene_of(with(rolling, "law =", "pivot = [0, 0, -0.1]\nlaw ="));
    EXPECT_TRUE(roll.tank_motion->law.turns);
    EXPECT_EQ(roll.tank_motion->pivot.z(), -0.1);
    EXPECT_FALSE(
        scene_of(swaying.substr(0, swaying.find("law")) + swaying.substr(swaying.find("[domain]"))).tank_motion);
}

TEST(TankMotion, RollsAboutTheLevelPositionFromRest) {
    const std::string about_level = with(rolling, "phase = \"90 deg\"", "ramp = 3");
    const MotionLaw law = scene_of(about_level).tank_motion->law;
    EXPECT_EQ(law.at(0).rate, 0);
    EXPECT_NEAR(law.at(3 + 0.75 * 1.5).path, -law.at(3 + 0.25 * 1.5).path, 1e-12);
    EXPECT_NEAR(law.at(3 + 0.25 * 1.5).path, 0.02, 1e-12);
    EXPECT_NE(complaint(with(rolling, "phase = \"90 deg\"\n", "")).find("a sinusoid with ramp, about its middle"),
              std::string::npos);
    EXPECT_NE(scene_of(about_level).hash, scene_of(rolling).hash);
}

TEST(TankMotion, MakesTheSoundFaster) {
    const Scene slow = scene_of(swaying), fast = scene_of(with(swaying, "amplitude = 0.02", "amplitude = 0.2"));
    EXPECT_NEAR(fast.sph.c0 - slow.sph.c0, 10 * 0.18 * 2 * M_PI / 1.5, 1e-9);
    // the far corner is the fastest place of one that rolls
    EXPECT_NEAR(fastest_wall(scene_of(rolling)), 0.02 * 2 * M_PI / 1.5 * std::hypot(0.5, 0.3), 1e-9);
}

TEST(TankMotion, IsRefusedWhereItCannotBeMeant) {
    expect_complaint(with(swaying, "law = \"sinusoid\"\n", ""), "law is missing");
    expect_complaint(with(swaying, "amplitude = 0.02\n", ""), "law = \"sinusoid\" needs it");
    expect_complaint(with(swaying, "amplitude = 0.02", "amplitude = 0"), "does not move");
    expect_complaint(with(swaying, "along = [1, 0, 0]\n", ""), "expected one of along");
    expect_complaint(with(swaying, "law =", "pivot = [0, 0, 0]\nlaw ="), "pivot");
    expect_complaint(with(swaying, "[1, 0, 0]", "[0, 1, 0]"), "leaves the plane");
    expect_complaint(with(rolling, "phase = \"90 deg\"\n", ""), "begins from rest");
    expect_complaint(with(with(swaying, "\"sinusoid\"", "\"table\""), "amplitude = 0.02\nperiod = 1.5",
                          "times = [0, 1, 1]\nvalues = [0, 0.1, 0]"),
                     "expected times that rise");
}

TEST(TankMotion, IsRefusedWithWhatIsNotSolvedInIt) {
    expect_complaint(swaying + "[motion]\nkind = \"stream\"\nspeed = 1\n", "no stream");
    expect_complaint(swaying + "[effects]\nforcing_zones = \"on\"\n", "tank at rest");
}

TEST(TankMotion, TakesHullsAndBodiesAlong) {
    const std::string body = "[[body]]\nshape = \"box\"\nlength = 0.2\nheight = 0.1\ndraft = 0.05\ndensity = 500\n";
    const Scene afloat = scene_of(swaying + body);
    EXPECT_EQ(afloat.bodies.size(), 1u);
    try {
        refuse_unmeshable(afloat);
        FAIL() << "OpenFOAM's source acts on the water alone";
    } catch (const InputError& e) { EXPECT_NE(std::string(e.what()).find("body1"), std::string::npos) << e.what(); }
    const std::string hull =
        "[motion]\nkind = \"none\"\n[hull]\nshape = \"box\"\nlength = 0.2\nbeam = 0.2\nheight = "
        "0.1\ndraft = 0.05\n";
    EXPECT_EQ(complaint(swaying + hull), "");
    EXPECT_NO_THROW(refuse_unmeshable(scene_of(swaying + hull)));
    const std::string plate =
        "[[body]]\nelastic = \"plate\"\n"
        "plate = [0.2, 0.2]\ncells = [10, 1]\nmiddle = [0, 0, -0.1]\nthickness = 0.01\nyoungs_modulus = 1e9\n"
        "poisson = 0.3\ndensity = 1000\nclamped = [\"x_min\"]\n";
    EXPECT_EQ(complaint(swaying + plate), "");
}

}  // namespace tank_motion_test
}  // namespace tw::test
