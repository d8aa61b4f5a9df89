#include "record/wet_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"

namespace tw {
namespace wet_wall_test {

/// A cylinder of unit radius across the plane in `faces` strips, wet up to `angle` from straight down on both sides.
WetWall cylinder(int faces, double angle, double pressure) {
    WetWall wall;
    for (int k = 0; k < faces; ++k) {
        const double at = 2 * pi * (k + 0.5) / faces - pi;
        wall.add(2 * pi / faces * Vec3(std::sin(at), 0, -std::cos(at)), pressure, std::abs(at) < angle);
    }
    return wall;
}

TEST(WetWall, WaterLeavesACylinderWhereItsWetPartEnds) {
    for (const double angle : {20., 60., 90., 130.})
        EXPECT_NEAR(cylinder(720, angle * degree, 0).leaving_angle() / degree, angle, 1) << angle;
    EXPECT_EQ(cylinder(36, 0, 0).leaving_angle(), 0) << "dry";
    EXPECT_EQ(cylinder(36, 2 * pi, 0).leaving_angle(), pi) << "wet all round";
}

TEST(WetWall, ADryPatchBelowAndAWetOneAboveMoveTheAngleByTheirAreaAlone) {
    WetWall wall = cylinder(720, 60 * degree, 0);
    const double area = 4 * degree;  // two degrees on either side
    wall.add(Vec3(0, 0, area), 0, true);
    EXPECT_NEAR(wall.leaving_angle() / degree, 62, 1);
}

TEST(WetWall, SuctionIsPressureBelowTheAirsOnWetFacesAlone) {
    EXPECT_EQ(cylinder(36, pi / 2, 200).suction_force(), 0);
    EXPECT_NEAR(cylinder(36, pi / 2, -50).suction_area(), pi, 1e-12);
    EXPECT_NEAR(cylinder(36, pi / 2, -50).suction_force(), 50 * pi, 1e-9);
}

}  // namespace wet_wall_test
}  // namespace tw
