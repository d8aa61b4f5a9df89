// Zones round a surface and grids of distances, against a ball.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/numbers.h"
#include "meshes/generate.h"
#include "meshes/zone.h"

namespace tw::test {
namespace zone_test {

constexpr double radius = 1;
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

// What is kept of distances from an edge that moves may be trusted as long as this bound allows.
TEST(Zone, DistancesChangeByNoMoreThanTheShiftOfTheirZone) {
    const auto distance = std::make_shared<const DistanceGrid>(ball(), around, 0.1, 1);
    const Zone start({{Vec3(-1.5, -2, -2), Vec3(1.5, 2, infinite)}, {Vec3(3, 0, 0), Vec3(4, 1, 1)}}, distance, 0.3);
    Zone before = start;
    Zone::Shift all;
    double closest = 0;
    for (int step = 1; step <= 6; ++step) {
        Eigen::Isometry3d way = Eigen::Isometry3d::Identity();
        way.translation() = Vec3(0.01, 0, -0.02) * step;
        way.rotate(Eigen::AngleAxisd(0.03 * step, Vec3::UnitY()));
        const Vec3 box_moved = Vec3(0.02, 0, 0.01) * step;
        const Zone now({{Vec3(-1.5, -2, -2) + box_moved, Vec3(1.5, 2, infinite) + box_moved}, start.boxes()[1]}, start,
                       way);
        const std::optional<Zone::Shift> shift = now.shift_since(before);
        ASSERT_TRUE(shift);
        all.by += shift->by;
        all.turn += shift->turn;
        for (double x = -2.5; x < 5; x += 0.21)
            for (double z = -2.5; z < 8; z += 0.23) {
                const Vec3 place(x, 0.3, z);
                const double r = (place - now.pivot()).norm();
                EXPECT_LE(std::abs(now.outside(place) - before.outside(place)), shift->by + shift->turn * r + 1e-12);
                const double change = std::abs(now.outside(place) - start.outside(place)),
                             bound = (all.by + all.turn * r) / (1 - all.turn);
                EXPECT_LE(change, bound + 1e-12);
                closest = std::max(closest, change / bound);
            }
        before = now;
    }
    EXPECT_GT(closest, 0.25);  // a bound without limit would never let a distance be kept
    EXPECT_FALSE(Zone(start.boxes()).shift_since(start));
    EXPECT_FALSE(Zone({start.boxes()[0]}, start, Eigen::Isometry3d::Identity()).shift_since(start));
    EXPECT_EQ(start.shift_since(start)->by, 0);
}

}  // namespace zone_test
}  // namespace tw::test
