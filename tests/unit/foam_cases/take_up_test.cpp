// What the record of an interFoam run that is resumed keeps of the one before.
#include "foam_cases/take_up.h"

#include <gtest/gtest.h>

#include "foam_cases/read/gaps.h"
#include "tests/unit/foam_cases/scenes.h"

namespace tw {
namespace take_up_test {

TEST(TakeUp, NothingThatWasFoundOnTheWayIsLost) {
    RunRecord earlier;
    earlier.attributes = {{loads_of, "all solids"},
                          {"mesh_warning", "an edge is missed"},
                          {"started", "yesterday"},
                          {"code_version", "old"},
                          {"restarts", "2"}};
    earlier.numbers = {{"hull_mesh_error", 0.01}, {"duration", 1}};
    earlier.table("forces").time = {0.1, 0.2};
    earlier.frames.push_back({0.1, {1, 2}});
    earlier.phases = {{"meshing", 3, 4}};
    earlier.hull.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    earlier.hull.triangles = {{0, 1, 2}};
    earlier.hull_pressure = {5};
    earlier.hull_wet = {1};
    RunRecord record;
    record.attributes = {{"started", "today"}, {"code_version", "new"}};
    record.numbers = {{"duration", 2}};
    record.hull.points = {Vec3::Zero()};
    take_up(earlier, record);
    EXPECT_EQ(record.attributes.at(loads_of), "all solids");
    EXPECT_EQ(record.attributes.at("mesh_warning"), "an edge is missed");
    EXPECT_EQ(record.attributes.at("started"), "yesterday");
    EXPECT_EQ(record.attributes.at("code_version"), "new");
    EXPECT_EQ(record.attributes.at("restarts"), "3");
    EXPECT_EQ(record.numbers.at("hull_mesh_error"), 0.01);
    EXPECT_EQ(record.numbers.at("duration"), 2) << "which may have grown";
    EXPECT_EQ(record.table("forces").time.size(), 2u);
    EXPECT_EQ(record.frames.size(), 1u);
    EXPECT_EQ(record.phases.size(), 1u);
    EXPECT_EQ(record.hull_pressure, std::vector<float>{5});
    EXPECT_EQ(record.hull.points.size(), 3u);
}

TEST(TakeUp, AHullThatWasNotDrawnYetStaysTheScenes) {
    RunRecord earlier, record;
    record.hull.points = {Vec3::Zero()};
    take_up(earlier, record);
    EXPECT_EQ(record.hull.points.size(), 1u);
    EXPECT_EQ(record.attributes.at("restarts"), "1");
}

TEST(TakeUp, AHullWithoutItsPressureIsNoWholeRecord) {
    const Scene with_hull = planing_scene(), tank = dam_break_scene();
    RunRecord record;
    EXPECT_TRUE(lacks_picture(plan_case(with_hull, Flavour{}), record));
    EXPECT_FALSE(lacks_picture(plan_case(tank, Flavour{}), record));
    record.hull_pressure = {1};
    EXPECT_FALSE(lacks_picture(plan_case(with_hull, Flavour{}), record));
}

}  // namespace take_up_test
}  // namespace tw
