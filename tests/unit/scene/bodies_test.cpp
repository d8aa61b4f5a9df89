#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/surface.h"
#include "scene/hash.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/solids/walls_met.h"
#include "scene_text.h"

namespace tw::test {
namespace bodies_test {

const std::string afloat = R"(title = "afloat"
[tank]
min = [-1, -1, -1]
max = [1, 1, 1]
[[body]]
shape = "box"
length = "0.4 m"
beam = "0.2 m"
height = "0.1 m"
draft = "0.05 m"
density = "500 kg/m3"
[motion]
kind = "none"
[resolution]
near_hull = "0.01 m"
[run]
duration = 1
methods = ["sph"]
)";

TEST(BodyScene, HasTheMassOfItsSurfaceAndDensity) {
    const MovingBody b = scene_of(afloat).bodies.at(0);
    EXPECT_EQ(b.name, "body1");
    EXPECT_NEAR(b.motion.mass.mass, 4, 1e-12);
    EXPECT_LT((b.motion.mass.centre - Vec3(0, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(b.motion.mass.inertia(1, 1), 4.0 / 12 * (0.16 + 0.01), 1e-12);
    EXPECT_TRUE(b.findings.empty());
    const MovingBody by_mass = scene_of(with(afloat, "density = \"500 kg/m3\"", "mass = 4")).bodies.at(0);
    EXPECT_LT((by_mass.motion.mass.inertia - b.motion.mass.inertia).norm(), 1e-12);
}

TEST(BodyScene, InTwoDimensionsIsASectionPerMetre) {
    const MovingBody b = scene_of(with(afloat, "[motion]", "[domain]\ndimensions = 2\n[motion]")).bodies.at(0);
    EXPECT_NEAR(b.motion.mass.mass, 20, 1e-12);
    EXPECT_FALSE(b.motion.free.along[1] || b.motion.free.about[0] || b.motion.free.about[2]);
    EXPECT_TRUE(b.motion.free.along[0] && b.motion.free.along[2] && b.motion.free.about[1]);
}

TEST(BodyScene, SpeedIsAlongItsAxisBowFirst) {
    const MovingBody b = scene_of(with(with(afloat, "draft = \"0.05 m\"", "draft = \"-0.1 m\"\ntrim = \"-60 deg\""),
                                       "[motion]", "speed = 10\n[motion]"))
                             .bodies.at(0);
    const double angle = std::numbers::pi / 3;
    EXPECT_LT((b.motion.velocity - 10 * Vec3(-std::cos(angle), 0, -std::sin(angle))).norm(), 1e-12);
}

TEST(BodyScene, InertiaTurnsWithTheShape) {
    const MovingBody b = scene_of(with(with(afloat, "draft = \"0.05 m\"", "draft = \"-0.1 m\"\ntrim = \"90 deg\""),
                                       "[motion]", "inertia = [1, 2, 2.5]\n[motion]"))
                             .bodies.at(0);
    EXPECT_LT((b.motion.mass.inertia - Vec3(2.5, 2, 1).asDiagonal().toDenseMatrix()).norm(), 1e-12);
}

TEST(BodyScene, ReadsPrescribedMotions) {
    const auto law = [](const std::string& lines) {
        return scene_of(with(afloat, "[motion]", "motion = \"prescribed\"\n" + lines + "\n[motion]"))
            .bodies.at(0)
            .motion.law.value();
    };
    const MotionLaw roll =
        law("law = \"sinusoid\"\nabout = [2, 0, 0]\namplitude = \"6 deg\"\nperiod = 2\nphase = \"90 deg\"");
    EXPECT_TRUE(roll.turns);
    EXPECT_EQ(roll.axis, Vec3::UnitX());
    EXPECT_NEAR(roll.amplitude, 6 * std::numbers::pi / 180, 1e-15);
    EXPECT_EQ(law("law = \"ramp\"\nalong = [1, 0, 0]\nrate = \"0.5 m/s\"\nramp = 0.5").ramp, 0.5);
    EXPECT_EQ(law("law = \"table\"\nalong = [0, 0, 1]\ntimes = [0, 1]\nvalues = [0, \"20 mm\"]").values[1], 0.02);
}

TEST(BodyScene, ChangesTheHashAndScenesWithoutBodiesKeepTheirs) {
    EXPECT_NE(scene_of(afloat).hash, scene_of(with(afloat, "500 kg", "501 kg")).hash);
    EXPECT_NE(scene_of(afloat).hash, scene_of(with(afloat, "[motion]", "locked = [\"surge\"]\n[motion]")).hash);
    EXPECT_EQ(canonical_text(scene_of(planing)).find("body"), std::string::npos);
}

TEST(BodyScene, FastBodiesNeedAFasterSound) {
    const double slow = scene_of(afloat).sph.c0;
    EXPECT_NEAR(scene_of(with(afloat, "[motion]", "velocity = [0, 0, 8]\n[motion]")).sph.c0, 80, 1e-9);
    EXPECT_LT(slow, 50);
}

// As of a hull that floats: the water where it stands is left out, and no error.
TEST(BodyScene, TakesThePlaceOfTheWaterInWhichItStarts) {
    const Scene s =
        scene_of(with(afloat, "[motion]", "[[water_block]]\nmin = [-1, -1, -1]\nmax = [1, 1, 0]\n[motion]"));
    EXPECT_EQ(s.bodies.size(), 1u);
    EXPECT_TRUE(s.bodies[0].findings.empty());
}

TEST(BodyScene, WarnsOfACentreOfMassOutside) {
    const Scene s = scene_of(with(afloat, "[motion]", "centre = [0, 0, 0.2]\ninertia = [1, 1, 1]\n[motion]"));
    ASSERT_EQ(s.bodies.at(0).findings.size(), 1u);
    EXPECT_EQ(s.bodies.at(0).findings[0].name, "centre_outside");
}

TEST(BodyScene, TheMeshGoesWithABodyAsItMayMove) {
    using Kind = MeshMotion::Kind;
    // Afloat at its draft it stays where it is: half of the way to the walls is far more than it needs.
    const MeshMotion rests = mesh_motion(scene_of(afloat));
    EXPECT_EQ(rests.kind, Kind::morphing);
    EXPECT_LT(rests.down + rests.up, 1e-3);
    EXPECT_NEAR(rests.outer, 0.98 * 0.8, 1e-9) << "the sides are nearest";
    // 10 mm above it, it swings 20 mm down: weight and buoyancy are its only forces, and its sides stand upright.
    const MeshMotion swings = mesh_motion(scene_of(with(afloat, "draft = \"0.05 m\"", "draft = \"0.04 m\"")));
    EXPECT_NEAR(swings.down, 0.02, 2e-4);
    // As heavy as lead and free to fall alone, it takes the whole mesh along; free to turn, in open water.
    const std::string lead = with(afloat, "500 kg", "11000 kg");
    const std::string down =
        with(lead, "[motion]", "locked = [\"surge\", \"sway\", \"roll\", \"pitch\", \"yaw\"]\n[motion]");
    EXPECT_EQ(mesh_motion(scene_of(down)).kind, Kind::sliding);
    EXPECT_EQ(mesh_motion(scene_of(lead)).kind, Kind::open_water);
    EXPECT_GT(mesh_motion(scene_of(lead)).down, 2) << "in a second";
    EXPECT_EQ(mesh_motion(scene_of(with(lead, "[motion]", "[fvm]\nbody_mesh = \"morphing\"\n[motion]"))).kind,
              Kind::morphing);
}

// Regions that overlapped would not move with either body.
TEST(BodyScene, TheMeshIsMorphedRoundSeveralBodiesUpToTheMiddleBetweenThem) {
    const Scene s = scene_of(with(afloat, "[motion]",
                                  "[[body]]\nshape = \"box\"\nlength = 0.2\nbeam = 0.2\nheight = 0.1\ndraft = 0.05\n"
                                  "position = [0.7, 0]\ndensity = \"500 kg/m3\"\n[motion]"));
    const MeshMotion m = mesh_motion(s);
    EXPECT_EQ(m.kind, MeshMotion::Kind::morphing);
    const double gap = s.bodies[1].surface.bounds().min.x() - s.bodies[0].surface.bounds().max.x();
    EXPECT_LT(m.outer, gap / 2);
    const double wall = s.domain.box.max.x() - s.bodies[1].surface.bounds().max.x();
    EXPECT_NEAR(m.outer, 0.98 * std::min(gap / 2, wall), 1e-9);
}

TEST(BodyScene, WhatTheMeshCannotMoveIsRefused) {
    const auto message = [](const std::string& text) -> std::string {
        const Scene s = scene_of(text);
        try {
            refuse_unmeshable(s);
        } catch (const InputError& e) { return e.what(); }
        return {};
    };
    EXPECT_EQ(message(afloat), "");
    const auto another = [](const std::string& place, const std::string& more = "density = \"500 kg/m3\"") {
        return with(afloat, "[motion]",
                    "[[body]]\nshape = \"box\"\nlength = 0.1\nbeam = 0.1\nheight = 0.1\ndraft = 0.05\nposition = [" +
                        place + "]\n" + more + "\n[motion]");
    };
    EXPECT_EQ(message(another("0.5, 0.5")), "");
    EXPECT_NE(message(another("0, 0.19"))
                  .find("from the middle between it and body body1; a mesh is morphed over four cells"),
              std::string::npos)
        << message(another("0, 0.19"));
    EXPECT_NE(message(another("0.5, 0.5", "density = \"9000 kg/m3\"")).find("body2 may move by"), std::string::npos);
    EXPECT_NE(
        message(another("0.5, 0.5", "motion = \"prescribed\"\nlaw = \"constant\"\nalong = [0, 0, 1]\nrate = 0.01"))
            .find("only where all are free"),
        std::string::npos);
    EXPECT_NE(message(with(another("0.5, 0.5"), "[motion]", "[fvm]\nbody_mesh = \"whole\"\n[motion]"))
                  .find("follows one body, and there are several"),
              std::string::npos);
    EXPECT_NE(message(with(afloat, "[motion]", "locked = [\"yaw\"]\n[motion]")).find("two of the three axes"),
              std::string::npos);
    const std::string post = "[[obstacle]]\nmin = [0.6, -0.1, -1]\nmax = [0.7, 0.1, -0.2]\n[motion]";
    EXPECT_EQ(message(with(afloat, "[motion]", post)), "") << "a mesh that is morphed leaves obstacles where they are";
    EXPECT_NE(message(with(with(afloat, "500 kg", "11000 kg"), "[motion]", post)).find("obstacle"), std::string::npos);
}

/// A paddle that turns round and round would take the mesh's floor out of the water and its top under it: interFoam's
/// volume fraction left its range from there on, and the run was lost after 240 degrees. The tank is as wide as it is deep
/// and high, so that happens at 45 degrees.
TEST(BodyScene, ATurnThatTakesTheMeshOutOfTheWaterIsRefused) {
    const auto message = [](const std::string& law) -> std::string {
        const Scene s = scene_of(with(afloat, "density = \"500 kg/m3\"", "motion = \"prescribed\"\n" + law));
        try {
            EXPECT_EQ(mesh_motion(s).kind, MeshMotion::Kind::open_water);
        } catch (const InputError& e) { return e.what(); }
        return {};
    };
    const std::string round = message("law = \"constant\"\nabout = [0, 1, 0]\nrate = 6.28");
    EXPECT_NE(round.find("corner of the mesh's floor comes above still water"), std::string::npos) << round;
    EXPECT_NE(round.find("turned by 45"), std::string::npos) << round;
    const std::string whole = "\n[fvm]\nbody_mesh = \"whole\"";
    EXPECT_EQ(message("law = \"sinusoid\"\nabout = [0, 1, 0]\namplitude = 0.7\nperiod = 1" + whole), "");
    EXPECT_NE(message("law = \"sinusoid\"\nabout = [0, 1, 0]\namplitude = 0.9\nperiod = 1" + whole), "");
    EXPECT_EQ(message("law = \"constant\"\nabout = [0, 0, 1]\nrate = 6.28"), "") << "about the vertical";
}

/// Corners that differ by noise leave holes; a body has no `repair`, so the way to a sound file is told.
TEST(BodyScene, ASurfaceThatCanBeRepairedSaysSo) {
    const Surface ball = make_hull("sphere", {{"diameter", 0.2}});
    Surface noisy;
    for (int t = 0; t < static_cast<int>(ball.triangles.size()); ++t) {
        const int n = static_cast<int>(noisy.points.size());
        for (int k = 0; k < 3; ++k)
            noisy.points.push_back(ball.corner(t, k) + Vec3::Constant(1e-8 * ((t * 7 + k) % 5)));
        noisy.triangles.push_back({n, n + 1, n + 2});
    }
    write_stl(scratch() / "ball.stl", noisy);
    const std::string text = with(afloat, "shape = \"box\"\nlength = \"0.4 m\"\nbeam = \"0.2 m\"\nheight = \"0.1 m\"",
                                  "file = \"ball.stl\"");
    EXPECT_NE(complaint(text).find("\"twinwake hull repair FILE NEW.stl\" repairs it"), std::string::npos)
        << complaint(text);
    write_stl(scratch() / "ball.stl", repair_surface(noisy).surface);
    EXPECT_EQ(complaint(text), "");
}

/// Beside a hull that is held, in a tank or a stream, a body moves in both methods; one that would go with the stream is
/// left to the particles, and so is one beside a hull that is free.
TEST(BodyScene, BodiesMoveBesideAHullAndInAStream) {
    const std::string hull =
        "[hull]\nshape = \"box\"\nlength = 0.3\nbeam = 0.2\nheight = 0.1\ndraft = 0.05\n"
        "position = [-0.6, 0]\n";
    EXPECT_NO_THROW(refuse_unmeshable(scene_of(with(afloat, "[motion]", hull + "[motion]"))));
    EXPECT_NE(complaint(with(afloat, "[motion]", with(hull, "-0.6", "-0.34") + "[motion]")).find("starts in the hull"),
              std::string::npos);
    const std::string stream =
        with(with(afloat, "kind = \"none\"", "kind = \"stream\"\nspeed = 1"),
             "[tank]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n", "[domain]\nx = [-2, 3]\ny = [-1, 1]\nz = [-1, 1]\n");
    const auto message = [](const std::string& text) -> std::string {
        try {
            refuse_unmeshable(scene_of(text));
        } catch (const InputError& e) { return e.what(); }
        return {};
    };
    EXPECT_NE(message(stream).find("lock its surge"), std::string::npos) << message(stream);
    EXPECT_EQ(message(with(stream, "[motion]", "locked = [\"surge\"]\n[motion]")), "");
    EXPECT_EQ(message(with(with(stream, "[motion]", "locked = [\"surge\"]\n[motion]"), "[motion]", hull + "[motion]")),
              "");
    const std::string both = with(stream, "[motion]", hull + "free = [\"heave\"]\nmass = 3\n[motion]");
    EXPECT_EQ(complaint(both), "");
    EXPECT_NE(message(both).find("beside a hull that is free"), std::string::npos) << message(both);
}

/// The corner of floor and wall is 0.2 m and 0.1 m from where the box's middle and keel are; what rounds to it stands on
/// it. The particles solve that contact, interFoam says what it misses; a stream's floor and sides are no walls to meet.
TEST(BodyScene, MayStandOnTheFloorAndAtTheWallsOfATank) {
    EXPECT_EQ(scene_of(afloat).bodies[0].friction, 0.5) << "the default that the reference states";
    EXPECT_TRUE(walls_touched(scene_of(afloat).bodies[0], scene_of(afloat)).empty());
    EXPECT_EQ(walls_met(scene_of(afloat).bodies[0], scene_of(afloat)).size(), 5u) << "the top is open";
    for (const char* draft : {"1", "1.0000001", "0.9999999"}) {
        const Scene s = scene_of(
            with(afloat, "draft = \"0.05 m\"", "position = [0.8, 0]\nfriction = 0.2\ndraft = " + std::string(draft)));
        const std::vector<MetWall> touched = walls_touched(s.bodies[0], s);
        ASSERT_EQ(touched.size(), 2u) << draft;
        EXPECT_EQ(touched[0].name + touched[1].name, "the wall at high xthe floor");
        EXPECT_EQ(s.bodies[0].friction, 0.2);
        try {
            refuse_unmeshable(s);
            FAIL();
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("body body1 stands on the wall at high x of the tank: the mesh method "
                                                 "has no contact"),
                      std::string::npos)
                << e.what();
        }
    }
    const std::string stream =
        with(with(afloat, "kind = \"none\"", "kind = \"stream\"\nspeed = 1"),
             "[tank]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n", "[domain]\nx = [-2, 3]\ny = [-1, 1]\nz = [-1, 1]\n");
    EXPECT_NE(complaint(with(stream, "draft = \"0.05 m\"", "draft = 1")).find("starts in a wall of the tank"),
              std::string::npos);
    const std::string moved =
        with(afloat, "[motion]", "motion = \"prescribed\"\nlaw = \"constant\"\nalong = [1, 0, 0]\nrate = 0\n[motion]");
    EXPECT_NE(complaint(with(moved, "draft = \"0.05 m\"", "draft = 1")).find("starts in a wall of the tank"),
              std::string::npos)
        << "what a law moves is not pushed off";
}

struct Bad {
    std::string from, to, message;
};
class BadBodies : public testing::TestWithParam<Bad> {};

TEST_P(BadBodies, AreRefusedAtTheirKey) {
    const auto& [from, to, message] = GetParam();
    const std::string said = complaint(with(afloat, from, to));
    EXPECT_EQ(said.substr(0, message.size()), message);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, BadBodies,
    testing::Values(
        Bad{"density = \"500 kg/m3\"", "mass = 0",
            "scene.toml:11:8: [[body]] mass = 0: out of range; expected greater than 0 kg"},
        Bad{"density = \"500 kg/m3\"", "mass = -2",
            "scene.toml:11:8: [[body]] mass = -2: out of range; expected greater than 0 kg"},
        Bad{"[motion]", "friction = -0.1\n[motion]",
            "scene.toml:12:12: [[body]] friction = -0.1: out of range; expected at least 0"},
        Bad{"[motion]",
            "friction = 0.1\nmotion = \"prescribed\"\nlaw = \"constant\"\nalong = [1, 0, 0]\nrate = 1\n[motion]",
            "scene.toml:12:12: [[body]] friction = 0.1: is for free bodies"},
        Bad{"density = \"500 kg/m3\"", "",
            "scene.toml:5:1: [[body]] mass: missing; a free body needs its mass or its density"},
        Bad{"density = \"500 kg/m3\"", "density = \"-500 kg/m3\"",
            "scene.toml:11:11: [[body]] density = \"-500 kg/m3\": out of range; expected greater than 0 kg/m3"},
        Bad{"[motion]", "inertia = [1, 1, -1]\n[motion]",
            "scene.toml:12:11: [[body]] inertia = [1, 1, -1]: no body has principal moments"},
        Bad{"[motion]", "motion = \"prescribed\"\nlaw = \"constant\"\nalong = [0, 0, -1]\nrate = 2\n[motion]",
            "scene.toml:13:7: [[body]] law = \"constant\": takes body body1 out of the tank: at 0.475 s it reaches z = "
            "-1 m, the tank -1 to 1 m"},
        Bad{"[motion]",
            "motion = \"prescribed\"\nlaw = \"table\"\nalong = [1, 0, 0]\ntimes = [0, 0.5]\nvalues = [0, "
            "0.9]\n[motion]",
            "scene.toml:13:7: [[body]] law = \"table\": takes body body1 out of the tank"},
        Bad{"[motion]", "mass = 3\n[motion]", "scene.toml:12:8: [[body]] mass = 3: given twice: also density"},
        Bad{"[motion]", "inertia = [1, 1, 3]\n[motion]",
            "scene.toml:12:11: [[body]] inertia = [1, 1, 3]: no body has principal moments of inertia 1, 1, 3 kg m2, "
            "of "
            "which "
            "the last is larger than the sum of the others"},
        Bad{"[motion]", "inertia = [1, 0, 1]\n[motion]",
            "scene.toml:12:11: [[body]] inertia = [1, 0, 1]: no body has principal moments"},
        Bad{"[motion]", "locked = [\"surge\", \"sway\", \"heave\", \"roll\", \"pitch\", \"yaw\"]\n[motion]",
            "scene.toml:12:10: [[body]] locked = [\"surge\", \"sway\", \"heave\", \"roll\", \"pitch\", \"yaw\"]: "
            "nothing "
            "is left"},
        Bad{"[motion]", "locked = [\"heave\"]\nvelocity = [0, 0, -1]\n[motion]",
            "scene.toml:13:12: [[body]] velocity = [0, 0, -1]: has a part in heave, which is locked"},
        Bad{"draft = \"0.05 m\"", "draft = 1.2",
            "scene.toml:10:9: [[body]] draft = 1.2: body body1 starts in a wall of the tank or outside it: in z it "
            "spans "
            "-1.2 to -1.1 m, the tank -1 to 1 m"},
        Bad{"draft = \"0.05 m\"", "draft = 0.05\nposition = [0.9, 0]",
            "scene.toml:11:12: [[body]] position = [0.9, 0]: body body1 starts in a wall of the tank"},
        Bad{"[motion]", "[[obstacle]]\nmin = [0.1, -0.1, -0.5]\nmax = [0.3, 0.1, 0]\n[motion]",
            "scene.toml:10:9: [[body]] draft = \"0.05 m\": body body1 starts in obstacle obstacle1"},
        Bad{"[motion]", "[[body]]\nshape = \"sphere\"\ndiameter = 0.2\ndraft = 0.1\nmass = 1\n[motion]",
            "scene.toml:15:9: [[body]] draft = 0.1: body body2 starts in body body1"},
        Bad{"[motion]", "motion = \"prescribed\"\n[motion]",
            "scene.toml:5:1: [[body]] law: missing; a prescribed motion"},
        Bad{"[motion]", "motion = \"prescribed\"\nlaw = \"constant\"\nrate = 1\n[motion]",
            "scene.toml:5:1: [[body]] along: expected one of along = [x, y, z]"},
        Bad{"[motion]", "motion = \"prescribed\"\nlaw = \"sinusoid\"\nalong = [1, 0, 0]\nperiod = 1\n[motion]",
            "scene.toml:5:1: [[body]] amplitude: missing; law = \"sinusoid\" needs it"},
        Bad{"[motion]", "motion = \"prescribed\"\nlaw = \"constant\"\nalong = [0, 0, 0]\nrate = 1\n[motion]",
            "scene.toml:14:9: [[body]] along = [0, 0, 0]: has no direction"},
        Bad{"[motion]",
            "motion = \"prescribed\"\nlaw = \"table\"\nalong = [1, 0, 0]\ntimes = [0, 2, 1]\nvalues = [0, 1, "
            "2]\n[motion]",
            "scene.toml:15:9: [[body]] times = [0, 2, 1]: row 2 is at 2 s and row 3 at 1 s; expected times that rise"},
        Bad{"[motion]",
            "motion = \"prescribed\"\nspin = [0, 0, 1]\nlaw = \"constant\"\nalong = [1, 0, 0]\nrate = 1\n[motion]",
            "scene.toml:13:8: [[body]] spin = [0, 0, 1]: is for free bodies"},
        Bad{"[motion]",
            "[domain]\ndimensions = 2\n[[body]]\nshape = \"box\"\nlength = 0.1\nbeam = 0.1\nheight = 0.1\n"
            "draft = 0.5\nmass = 1\nspin = [1, 0, 0]\n[motion]",
            "scene.toml:21:8: [[body]] spin = [1, 0, 0]: has a part in roll, which is locked (two dimensions"},
        Bad{"[run]", "[sph]\nscheme = \"rk4_frozen_diffusion\"\n[run]",
            "scene.toml:17:10: [sph] scheme = \"rk4_frozen_diffusion\": the added mass of free bodies is taken "
            "into account once a step"}));

// A centre far outside leaves a uniform solid no inertia that a body can have, and a law needs none.
TEST(Bodies, WhatALawMovesIsNotAskedForItsInertia) {
    const std::string outside = with(afloat, "[motion]", "centre = [0, 0, 0.9]\n[motion]"),
                      law = "motion = \"prescribed\"\nlaw = \"constant\"\nalong = [1, 0, 0]\nrate = 0.01\n[motion]";
    EXPECT_NE(complaint(outside).find("so give inertia"), std::string::npos) << complaint(outside);
    EXPECT_EQ(complaint(with(outside, "[motion]", law)), "");
}

}  // namespace bodies_test
}  // namespace tw::test
