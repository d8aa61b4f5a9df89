// What a wave has to come over before it reaches a box of water, as the record knows it.
#include "scene/solids/sea_wall.h"

#include "meshes/generate.h"
#include "record/run_record.h"
#include "scene/new_record.h"
#include "scene_text.h"

namespace tw::test {
namespace sea_wall_test {

/// A tank in two dimensions with a wave and a box from x = 0.3 m on.
std::string tank(const std::string& obstacles, const std::string& direction = "0 deg") {
    return "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.01, 0.12]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.04\n"
           "length = 1\ndirection = \"" +
           direction + "\"\n[resolution]\nnear_hull = 0.01\n[[volume]]\nname = \"behind\"\nmin = [0.3, 0, -0.24]\n" +
           "max = [1.6, 1, 1]\n" + obstacles;
}
std::string box(double x, double from, double top) {
    return "[[obstacle]]\nmin = [" + std::to_string(x) + ", -1, " + std::to_string(from) + "]\nmax = [" +
           std::to_string(x + 0.1) + ", 1, " + std::to_string(top) + "]\n";
}
std::optional<SeaWall> wall_of(const std::string& text) {
    const Scene scene = scene_of(text);
    return sea_wall_before(scene, scene.sampling.volumes.at(0).box);
}

TEST(SeaWall, IsTheHighestObstacleBeforeTheBox) {
    const auto wall = wall_of(tank(box(0.1, -0.24, 0.03) + box(-0.2, -0.24, 0.01) + box(0.5, -0.24, 0.08)));
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->freeboard, 0.03, 1e-6);
    EXPECT_EQ(wall->cot_slope, 0);
    EXPECT_NEAR(wall->depth, 0.24, 1e-6);
    EXPECT_EQ(new_record(scene_of(tank(box(0.1, -0.24, 0.03))), "fvm").numbers.at("wall_freeboard_behind"),
              wall->freeboard);
}

TEST(SeaWall, IsNoneThatWaterPassesUnderOrThatItCoversOrThatStandsBehind) {
    EXPECT_FALSE(wall_of(tank(box(0.1, -0.1, 0.03))));
    EXPECT_FALSE(wall_of(tank(box(0.1, -0.24, -0.01))));
    EXPECT_FALSE(wall_of(tank(box(0.5, -0.24, 0.03))));
    EXPECT_FALSE(wall_of(tank(box(-0.2, -0.24, 0.03), "180 deg")));
    EXPECT_FALSE(wall_of(tank("")));
    EXPECT_FALSE(new_record(scene_of(tank("")), "fvm").numbers.contains("wall_freeboard_behind"));
    EXPECT_FALSE(new_record(scene_of(tank(box(0.1, -0.1, 0.03))), "fvm").numbers.contains("slope_crest_obstacle1"));
}

TEST(SeaWall, HasTheSlopeOfItsSeawardFaceAboveStillWater) {
    Surface dike = make_hull("box", {{"length", 0.6}, {"beam", 2}, {"height", 0.3}});
    const Box at = dike.bounds();
    for (Vec3& p : dike.points) {
        const bool front = p.x()<at.min.x() + 0.3, top = p.z()> at.min.z() + 0.15;
        p.x() += -0.4 - at.min.x() + (front && top ? 1.5 * 0.3 : 0);  // 1 in 1.5 on the left, upright on the right
        p.z() += -0.24 - at.min.z();
    }
    write_stl(scratch() / "dike.stl", dike);
    const auto wall = wall_of(tank("[[obstacle]]\nfile = \"dike.stl\"\n"));
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->freeboard, 0.06, 1e-6);
    EXPECT_NEAR(wall->cot_slope, 1.5, 1e-4);
    EXPECT_TRUE(wall->plane);
    const RunRecord record = new_record(scene_of(tank("[[obstacle]]\nname = \"dike\"\nfile = \"dike.stl\"\n")), "sph");
    EXPECT_NEAR(record.numbers.at("slope_cot_dike"), 1.5, 1e-4);
    EXPECT_NEAR(record.numbers.at("slope_crest_dike"), 0.06, 1e-6);
    EXPECT_EQ(record.numbers.at("slope_plane_dike"), 1);
    Surface bent;  // upright from the floor to z = -0.1 m, then 1 in 1.5
    for (const double y : {1.0, -1.0})
        for (const auto& [x, z] : {std::pair{-0.4, -0.24}, {-0.4, -0.1}, {-0.16, 0.06}, {0.2, 0.06}, {0.2, -0.24}})
            bent.points.emplace_back(x, y, z);
    for (int i = 0; i < 5; ++i) {
        bent.triangles.push_back({i, i + 5, (i + 1) % 5});
        bent.triangles.push_back({(i + 1) % 5, i + 5, (i + 1) % 5 + 5});
    }
    bent.triangles.insert(bent.triangles.end(), {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {5, 7, 6}, {5, 8, 7}, {5, 9, 8}});
    write_stl(scratch() / "dike.stl", bent);
    EXPECT_FALSE(wall_of(tank("[[obstacle]]\nfile = \"dike.stl\"\n"))->plane);
}

}  // namespace sea_wall_test
}  // namespace tw::test
