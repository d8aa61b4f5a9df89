// Zones round a surface and grids of distances, against a ball.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "meshes/generate.h"
#include "meshes/zone.h"

namespace tw::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), radius = 1;
const Box around{Vec3::Constant(-2), Vec3::Constant(2)};

Surface ball() { return posed(make_hull("sphere", {{"diameter", 2 * radius}}), {.draft = radius}); }

TEST(DistanceGrid, IsTheDistanceBetweenItsNodesAndEndsAtItsReach) {
    const DistanceGrid grid(ball(), around, 0.1, 0.5);
    for (const Vec3& x : {Vec3(1.23, 0.1, 0.2), Vec3(-0.4, 0.9, -0.6), Vec3(0.1, -0.2, -0.75)})
        EXPECT_NEAR(grid.at(x), x.norm() - radius, 0.005) << x.transpose();
    EXPECT_NEAR(grid.at({1.9, 1.9, 1.9}), 0.5, 1e-6);
    EXPECT_NEAR(grid.at({9, 0, 0}), grid.at({2, 0, 0}), 1e-12);  // beyond the box
}

TEST(DistanceGrid, DrawnOutUpwardsHoldsWhatStandsAboveTheSurface) {
    DistanceGrid grid(ball(), around, 0.1, 1);
    const Vec3 above(0.3, 0.2, 1.9), below(0.3, 0.2, -1.9);
    EXPECT_GT(grid.at(above), 0.8);
    grid.draw_out(2, true);
    EXPECT_NEAR(grid.at(above), std::hypot(0.3, 0.2) - radius, 0.01);  // half way up the ball
    EXPECT_GT(grid.at(below), 0.8);
}

TEST(Zone, RoundASurfaceIsAShellOfItsWidthWithinItsBox) {
    const auto distance = std::make_shared<const DistanceGrid>(ball(), around, 0.05, 1);
    const Zone zone({{Vec3(-0.5, -2, -2), Vec3(2, 2, infinite)}, {Vec3(3, 0, 0), Vec3(4, 1, 1)}}, distance, 0.3);
    EXPECT_NEAR(zone.outside({1.1, 0, 0}), -0.2, 0.01);
    EXPECT_NEAR(zone.outside({0, 0, -1.5}), 0.2, 0.01);
    EXPECT_NEAR(zone.outside({-0.7, 0, 0}), 0.2, 1e-9);      // its box ends there
    EXPECT_NEAR(zone.outside({3.5, 0.5, 0.5}), -0.5, 1e-9);  // the other box
    const std::vector<Box> slices = zone.sliced();
    ASSERT_GT(slices.size(), 10u);
    double deepest = 0;
    for (const Box& slice : slices) {
        deepest = std::min(deepest, slice.min.z());
        EXPECT_EQ(slice.max.z(), slice.min.x() < 2.5 ? infinite : 1);
    }
    EXPECT_NEAR(deepest, -1.3, 0.06);
    EXPECT_GT(slices[slices.size() - 2].min.z(), -0.9);  // where the ball ends the zone is less deep
}

}  // namespace
}  // namespace tw::test
