#include "record/wet_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"
#include "free_streamline.h"

namespace tw {
namespace wet_wall_test {

/// A cylinder of unit radius across the plane in `faces` strips, wet up to `angle` from straight down on both sides.
WetWall cylinder(int faces, double angle, double pressure) {
    WetWall wall;
    for (int k = 0; k < faces; ++k) {
        const double at = 2 * pi * (k + 0.5) / faces - pi;
        const bool wet = std::abs(at) < angle;
        wall.add(2 * pi / faces * Vec3(std::sin(at), 0, -std::cos(at)), pressure, wet, wet ? 0 : 1);
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
    wall.add(Vec3(0, 0, area), 0, true, 0);
    EXPECT_NEAR(wall.leaving_angle() / degree, 62, 1);
}

// Where water leaves a cylinder in a free jet smoothly is known, and the streamline behind (tests/data/README.md).
TEST(WetWall, ASheetThatLeavesSmoothlyHasLeftWhereItsGapBegins) {
    const FreeStreamlines exact;
    for (const auto& [breadth, line] : exact.lines)
        for (const double spacings : {5.5, 11., 22., 44.}) {  // in the radius
            WetWall wall;
            double within_half = 0;
            constexpr int faces = 1440;
            for (int k = 0; k < faces; ++k) {
                const double at = 2 * pi * (k + 0.5) / faces - pi, gap = spacings * line.gap(std::abs(at) / degree);
                wall.add(2 * pi / faces * Vec3(std::sin(at), 0, -std::cos(at)), 0, gap < 0.5, std::min(gap, 1.0));
                if (gap < 0.5) within_half = std::max(within_half, std::abs(at));
            }
            EXPECT_NEAR(wall.leaving_angle() / degree, line.leaves(), 1.5) << breadth << ", " << spacings;
            EXPECT_GT(within_half / degree, line.leaves() + (spacings < 30 ? 15 : 11)) << "or there is nothing to mend";
        }
}

TEST(WetWall, SuctionIsPressureBelowTheAirsOnWetFacesAlone) {
    EXPECT_EQ(cylinder(36, pi / 2, 200).suction_force(), 0);
    EXPECT_NEAR(cylinder(36, pi / 2, -50).suction_area(), pi, 1e-12);
    EXPECT_NEAR(cylinder(36, pi / 2, -50).suction_force(), 50 * pi, 1e-9);
}

}  // namespace wet_wall_test
}  // namespace tw
