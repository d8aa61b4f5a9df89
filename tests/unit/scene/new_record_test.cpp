#include <gtest/gtest.h>

#include "base/numbers.h"
#include "methods/methods.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene_text.h"

namespace tw {
namespace new_record_test {

// A mesh ends elsewhere at each size, the scene's hull does not: records of a family have their cuts in one place.
TEST(NewRecord, CutsWithoutAWordFollowFromTheScenesHull) {
    Scene scene;
    Hull hull;
    hull.beam = 1;
    hull.surface.points = {{-2, -0.5, 0}, {2, 0.5, 1}, {0, 0, -0.2}};
    hull.surface.triangles = {{0, 1, 2}};
    scene.hull = hull;
    EXPECT_EQ(new_record(scene, "fvm").numbers.at("cut_x_0"), 2 + 0.5 * 4);
    EXPECT_EQ(new_record(scene, "fvm").numbers.at("cut_y_0"), 0.75);
    scene.sampling.cuts_y = {0.25};
    EXPECT_EQ(new_record(scene, "fvm").numbers.at("cut_y_0"), 0.25);
    EXPECT_FALSE(new_record(scene, "fvm").numbers.contains("cut_x_0"));
}

TEST(NewRecord, CarriesWhatTheSceneSays) {
    Scene scene;
    scene.title = "t";
    scene.hash = "abc";
    scene.text = "title = \"t\"";
    scene.motion = {Motion::Kind::stream, 8, 0.1};
    scene.sampling.raster = {{0, 0, 0}, 0.1, {2, 3, 4}};
    scene.sampling.cuts_y = {0.25};
    scene.effects = {{"air", false, false, "r", "i", 0}};
    Hull hull;
    hull.hash = "h";
    hull.half = true;
    hull.trim = 0.0875;
    hull.draft = 0.2;
    hull.surface.points = {{-2, -0.5, 0}, {2, 0.5, 1}, {0, 0, -0.2}};
    hull.surface.triangles = {{0, 1, 2}};
    scene.hull = hull;
    const RunRecord r = new_record(scene, "sph");
    EXPECT_EQ(r.attributes.at("method"), "sph");
    EXPECT_EQ(r.attributes.at("scene_hash"), "abc");
    EXPECT_EQ(r.attributes.at("run_hash"), run_hash(scene, "sph"));
    EXPECT_EQ(r.attributes.at("family_hash"), family_hash(scene, "sph"));  // what sizes of one scene share
    EXPECT_NE(r.attributes.at("family_hash"), r.attributes.at("run_hash"));
    EXPECT_EQ(r.attributes.at("hull_hash"), "h");
    EXPECT_EQ(r.attributes.at("symmetry_factor"), "2");
    EXPECT_EQ(r.attributes.at("moment_reference"), "0 0 0");
    EXPECT_FALSE(r.attributes.at("code_version").empty());
    EXPECT_FALSE(r.attributes.at("compiler").empty());
    EXPECT_FALSE(r.attributes.at("machine").empty());
    EXPECT_EQ(r.numbers.at("speed"), 8);
    EXPECT_EQ(r.numbers.at("trim"), 0.0875);
    EXPECT_EQ(r.numbers.at("cut_y_0"), 0.25);
    EXPECT_EQ(r.raster.count, (std::array<int, 3>{2, 3, 4}));
    EXPECT_EQ(r.hull.triangles.size(), 1u);
    EXPECT_EQ(r.effects.size(), 1u);
    EXPECT_EQ(r.scene_text, scene.text);
    EXPECT_EQ(r.state, "running");
}

// Both methods show the body that the scene has, from the same surface; one that bends has none that could be moved.
TEST(NewRecord, SaysWhatTheWallsOfTheBoxDo) {
    const std::string narrow = test::planing + "[domain]\nside = 1.5\nbelow = 1.2\n",
                      wide = test::planing + "[domain]\nside = 8\nbelow = 8\n";
    EXPECT_NE(new_record(test::scene_of(narrow), "sph").attributes.at("box_walls").find("raise the lift by"),
              std::string::npos);
    EXPECT_FALSE(new_record(test::scene_of(wide), "sph").attributes.contains("box_walls"));
    EXPECT_FALSE(new_record(test::scene_of(narrow), "sph").attributes.contains("channel"));
    const std::string channel = test::planing + "[water]\ndepth = 1.2\n[domain]\nside = 1.5\nsides = \"walls\"\n";
    const RunRecord record = new_record(test::scene_of(channel), "sph");
    EXPECT_TRUE(record.attributes.at("channel").starts_with("a channel of this size"));
    EXPECT_FALSE(record.attributes.contains("box_walls"));
}

TEST(NewRecord, HoldsTheBodiesThatKeepTheirShape) {
    Scene scene;
    MovingBody body;
    body.name = "ball";
    body.surface.points = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    body.surface.triangles = {{0, 1, 2}};
    body.motion.mass.centre = {0.25, 0, 1};
    scene.bodies.push_back(body);
    for (const char* method : {"sph", "fvm"}) {
        const RunRecord r = new_record(scene, method);
        ASSERT_EQ(r.bodies.size(), 1u);
        EXPECT_EQ(r.bodies[0].table, "body_ball");
        EXPECT_EQ(r.bodies[0].surface.points, body.surface.points);
        EXPECT_EQ(r.bodies[0].centre, body.motion.mass.centre);
    }
    scene.bodies[0].elastic = ElasticPlate{};
    EXPECT_TRUE(new_record(scene, "sph").bodies.empty());
    EXPECT_EQ(new_record(scene, "fvm").bodies.size(), 1u) << "interFoam's counterpart is rigid";
}

/// A further method says where its solution is finer as well, or new_record throws here.
TEST(NewRecord, EveryMethodSaysWhereItsSolutionIsFiner) {
    const Scene scene = test::scene_of(test::planing + "[sph]\nlevels = 2\n");
    for (const Method& m : methods()) EXPECT_GT(new_record(scene, m.name).resolution.size(), 1u) << m.name;
    EXPECT_TRUE(new_record(scene, "measured").resolution.empty()) << "nobody knows";
}

// A scene's boxes may go on through the sky or lie half outside: what is recorded can be drawn.
TEST(Resolution, IsTheDomainAndWhatOfTheFinerBoxesLiesInIt) {
    const Box domain{{-2, 0, -1}, {4, 2, 1}};
    const std::vector<ResolvedBox> r = resolution_within(
        {0.2, domain}, {{0.1, {{-1, -infinite, -0.5}, {1, 1, infinite}}}, {0.05, {{5, 0, 0}, {6, 1, 1}}}});
    ASSERT_EQ(r.size(), 2u);
    EXPECT_EQ(r[0].size, 0.2);
    EXPECT_EQ(r[1].box.min, Vec3(-1, 0, -0.5));
    EXPECT_EQ(r[1].box.max, Vec3(1, 1, 1));
}

}  // namespace new_record_test
}  // namespace tw
