// The empirical overtopping of a wall that stands beside the runs'.
#include "compare/reference/overtopping.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw::test {
namespace overtopping_test {

const WavesAtWall vertical{.height = 0.1, .period = 1, .depth = 0.5, .freeboard = 0.1, .cot_slope = 0, .gravity = 9.81};

TEST(EurOtop, GivesThePublishedCoefficientsAtBothEndsOfItsSlopes) {
    const double scale = std::sqrt(9.81 * 1e-3);
    const auto wall = eurotop_overtopping(vertical);
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->rate / scale, 0.047 * std::exp(-std::pow(2.35, 1.3)), 1e-5) << "eq. 7.1";
    // 0.15 of a, and 1.3 * 2.35^1.3 * 0.1 = 0.395 of b
    EXPECT_NEAR(wall->half_width / wall->rate, 1.96 * std::hypot(0.15, 0.395), 2e-3);
    EXPECT_TRUE(wall->in_range);
    WavesAtWall slope = vertical;
    slope.cot_slope = 2;
    EXPECT_NEAR(eurotop_overtopping(slope)->rate / scale, 0.09 * std::exp(-std::pow(1.5, 1.3)), 1e-9) << "eq. 5.11";
    slope.cot_slope = 2.01;
    EXPECT_FALSE(eurotop_overtopping(slope));
}

TEST(EurOtop, SaysWhereItIsNoMoreThanAHint) {
    WavesAtWall high = vertical, shallow = vertical, drowned = vertical;
    high.freeboard = 0.36;
    EXPECT_FALSE(eurotop_overtopping(high)->in_range);
    shallow.depth = 0.18;  // h^2 / (Hm0 g T^2 / 2 pi) = 0.21: waves break against the wall
    EXPECT_FALSE(eurotop_overtopping(shallow)->in_range);
    drowned.freeboard = -0.01;
    EXPECT_FALSE(eurotop_overtopping(drowned));
}

}  // namespace overtopping_test
}  // namespace tw::test
