// Input that is probably another unit, or another thing, than the one meant: asked back or warned of.
#include "scene/doubtful_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "meshes/generate.h"
#include "scene/new_record.h"
#include "scene_text.h"

namespace tw::test {
namespace doubtful_input_test {

std::string found_in(const Scene& scene, const std::string& name) {
    for (const std::vector<Finding>& all :
         {doubtful_input(scene), scene.hull ? scene.hull->findings : std::vector<Finding>{}})
        for (const Finding& f : all)
            if (f.name == name) return f.message;
    return {};
}
std::string found_in(const std::string& text, const std::string& name) { return found_in(scene_of(text), name); }

const std::string tank =
    "[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [1, 1, 0.5]\n[motion]\nkind = "
    "\"none\"\n[resolution]\nnear_hull = 0.05\n[run]\nduration = 1\n";

TEST(DoubtfulInput, ADynamicViscosityGivenForAKinematicOne) {
    for (const char* value : {"1e-3", "0.00114", "\"1e-3 m2/s\""}) {
        const Scene scene = scene_of(tank + "[water]\nviscosity = " + value + "\n");
        EXPECT_NE(found_in(scene, "dynamic_viscosity").find("times water's"), std::string::npos) << value;
        EXPECT_NE(to_text(scene, predict(scene)).find("warning   dynamic_viscosity: "), std::string::npos);
        EXPECT_NE(warnings_text(scene).find("warning: dynamic_viscosity: "), std::string::npos);
        EXPECT_EQ(new_record(scene, "sph").attributes.at("scene_finding_00").substr(0, 19), "dynamic_viscosity: ");
    }
    for (const char* value : {"1e-6", "\"1.8 cSt\"", "\"100 cSt\"", "0"})
        EXPECT_EQ(found_in(tank + "[water]\nviscosity = " + value + "\n", "dynamic_viscosity"), "") << value;
    EXPECT_EQ(found_in(tank + "[water]\nviscosity = 1e-3\ndensity = 850\n", "dynamic_viscosity"), "") << "an oil";
    EXPECT_NE(complaint(tank + "[water]\nviscosity = \"1 mPa s\"\n").find("a unit of the dynamic viscosity"),
              std::string::npos);
}

TEST(DoubtfulInput, ADensityInGramsAndATensionInMillinewtons) {
    EXPECT_NE(found_in(tank + "[water]\ndensity = 1.025\n", "odd_density"), "");
    EXPECT_NE(found_in(tank + "[water]\nsurface_tension = 7.28\n", "odd_tension"), "");
    EXPECT_EQ(warnings_text(scene_of(tank)), "");
}

TEST(DoubtfulInput, AMassInTonnes) {
    const auto free = [](const std::string& mass) {
        return with(planing, "half     = true\n",
                    "half     = true\nfree = [\"heave\", \"pitch\"]\nlcg = 1.6\nvcg = 0.3\nmass = " + mass + "\n");
    };
    EXPECT_NE(found_in(free("0.3"), "odd_mass").find("0.3 kg, "), std::string::npos);
    EXPECT_NE(found_in(free("0.3"), "odd_mass").find(" times less than the "), std::string::npos);
    EXPECT_NE(warnings_text(scene_of(free("0.3"))).find("warning: odd_mass: "), std::string::npos);
    EXPECT_NE(found_in(free("3e5"), "odd_mass").find(" times more than the "), std::string::npos);
    for (const char* mass : {"300", "\"0.3 t\"", "150", "800"}) EXPECT_EQ(found_in(free(mass), "odd_mass"), "") << mass;
    const std::string box = tank +
                            "[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.4\nbeam = 0.4\nheight = 0.4\n"
                            "position = [0.5, 0.5]\ndraft = -0.55\n";
    EXPECT_NE(found_in(box + "density = 0.6\n", "odd_mass").find("the mass of body box is 0.0384 kg, "),
              std::string::npos);
    EXPECT_EQ(found_in(box + "density = 600\n", "odd_mass"), "");
}

// A block 0.2 m high in half a metre of water.
TEST(DoubtfulInput, ABodyOnTheFloorThatHardlyStandsThere) {
    const auto block = [](double density) {
        return tank +
               fmt::format(
                   "[[body]]\nname = \"block\"\nshape = \"box\"\nlength = 0.2\nbeam = 0.2\nheight = 0.2\ndraft = 0\n"
                   "position = [0.5, 0.5]\ndensity = {}\n",
                   density);
    };
    EXPECT_NE(found_in(block(1200), "hardly_standing").find("weighs 1.2 times its buoyancy"), std::string::npos);
    EXPECT_EQ(found_in(block(2100), "hardly_standing"), "") << "stands";
    EXPECT_EQ(found_in(block(900), "hardly_standing"), "") << "rises, as it should";
    const std::string dry = with(block(1200), "max = [1, 1, 0.5]", "max = [0.2, 1, 0.5]");
    EXPECT_EQ(found_in(dry, "hardly_standing"), "") << "the water stands elsewhere";
}

TEST(DoubtfulInput, ATableThatEndsBeforeTheRunWhileItMoves) {
    const auto lifted = [](const std::string& duration) {
        return "[tank]\nsize = [1, 1, 1]\nlaw = \"table\"\nalong = [0, 0, 1]\ntimes = [0, 0.2, 0.4, 0.6]\nvalues = [0, "
               "0.04, "
               "0.16, 0.36]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [1, 1, 0.5]\n[motion]\nkind = "
               "\"none\"\n[resolution]\n"
               "near_hull = 0.05\n[run]\nduration = " +
               duration + "\n";
    };
    EXPECT_EQ(found_in(lifted("0.6"), "table_moves_on"), "");
    EXPECT_EQ(
        found_in(lifted("1"), "table_moves_on"),
        "the table of the tank's motion ends at 0.6 s while it moves at 1.2 m/s, and the run lasts 1 s: it keeps that "
        "velocity, and its acceleration of 2 m/s2 stops there");
    const Scene scene = scene_of(lifted("0.6"));
    const std::string text = to_text(scene, predict(scene));
    EXPECT_NE(text.find("as prescribed (table) along (0, 0, 1), at most 1.2 m/s and 2 m/s2"), std::string::npos)
        << text;
    EXPECT_NE(text.find("4 rows, at most 1 m/s from row to row; it begins at rest and ends at 0.6 s at 1.2 m/s"),
              std::string::npos)
        << text;
}

TEST(DoubtfulInput, AnAngleBeyondFifteenDegreesWithoutAUnitIsAskedBack) {
    EXPECT_EQ(complaint(with(planing, "\"5 deg\"", "0.5")),
              "scene.toml:7:12: [hull] trim = 0.5: a number without a unit is in radians, and this is 28.6 degrees, "
              "more than "
              "15; expected \"0.5 deg\", or \"0.5 rad\" where that is meant");
    EXPECT_NE(complaint(with(planing, "\"5 deg\"", "\"0.5\"")).find("this is 28.6 degrees"), std::string::npos);
    for (const char* trim : {"\"0.5 rad\"", "\"28.6 deg\"", "0.2", "\"0.5 deg\""})
        EXPECT_EQ(complaint(with(with(planing, "\"5 deg\"", trim), "\"0.2 m\"", "\"0.4 m\"")), "") << trim;
    SceneOverrides overrides;
    overrides.trim = 0.5;  // of the command line, which asks itself
    EXPECT_EQ(complaint(with(planing, "\"0.2 m\"", "\"0.4 m\""), overrides), "");
    const Scene scene = scene_of(tank +
                                 "[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.3\nbeam = 0.3\nheight = 0.2\n"
                                 "position = [0.5, 0.5]\ndraft = -0.55\ndensity = 600\ntrim = 0.5\n");
    EXPECT_NE(warnings_text(scene).find("plain_angle: trim of body box: a number without a unit is in radians"),
              std::string::npos);
}

TEST(DoubtfulInput, WhatTurnsAwayToNothingIsZeroDegrees) {
    const Scene scene = scene_of(with(planing, "\"5 deg\"", "5.7e-18"));
    EXPECT_NE(to_text(scene, predict(scene)).find("; trim 0 deg, draft"), std::string::npos);
}

/// A V-bottom with a transverse step of `step` at midships, or chines with a flat of that width.
std::string stepped(double step) {
    Surface s;
    const auto section = [&](double x, double keel) {
        const int first = static_cast<int>(s.points.size());
        for (const Vec3& p : {Vec3(x, -0.5, 0.4), Vec3(x, -0.5, keel + 0.15), Vec3(x, 0, keel),
                              Vec3(x, 0.5, keel + 0.15), Vec3(x, 0.5, 0.4)})
            s.points.push_back(p);
        return first;
    };
    const int bow = section(-2, -0.2), before = section(0, -0.2), behind = section(0, -0.2 + step),
              stern = section(2, -0.2 + step);
    const auto quad = [&](int a, int b, int c, int d) {
        s.triangles.push_back({a, b, c}), s.triangles.push_back({a, c, d});
    };
    const auto shell = [&](int a, int b) {
        for (int k = 1; k < 3; ++k) quad(a + k, a + k + 1, b + k + 1, b + k);
        quad(a, b, b + 4, a + 4);  // the deck
    };
    shell(bow, before);
    shell(behind, stern);
    quad(behind, behind + 1, stern + 1, stern);
    quad(behind + 3, behind + 4, stern + 4, stern + 3);
    // the sides before the step, whose after edges have the corners of both sections
    quad(bow, bow + 1, before + 1, behind + 1);
    s.triangles.push_back({bow, behind + 1, before});
    quad(bow + 3, bow + 4, before + 4, behind + 3);
    s.triangles.push_back({bow + 3, behind + 3, before + 3});
    for (int k = 1; k < 3; ++k) quad(before + k, before + k + 1, behind + k + 1, behind + k);  // the riser
    for (int k = 1; k < 4; ++k) s.triangles.push_back({bow, bow + k + 1, bow + k});
    for (int k = 1; k < 4; ++k) s.triangles.push_back({stern, stern + k, stern + k + 1});
    write_stl(scratch() / "stepped.stl", welded(s));
    return "[hull]\nfile = \"stepped.stl\"\ndraft = 0.3\n[motion]\nspeed = 8\n[resolution]\nnear_hull = 0.1\n" +
           one_size;
}

TEST(DoubtfulInput, AStepFinerThanTheSizeAtTheHullIsNamedInSpacings) {
    const std::string fine = found_in(stepped(0.04), "narrow_part");
    EXPECT_NE(fine.find("a step, chine or rail near (0, "), std::string::npos) << fine;
    EXPECT_NE(fine.find(" spacings of near_hull = 0.1 m"), std::string::npos) << fine;
    EXPECT_EQ(found_in(stepped(0.14), "narrow_part"), "");
    EXPECT_EQ(found_in(planing, "narrow_part"), "");
}

}  // namespace doubtful_input_test
}  // namespace tw::test
