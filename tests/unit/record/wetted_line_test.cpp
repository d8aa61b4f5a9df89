#include <gtest/gtest.h>

#include "record/wetted_line.h"

namespace tw {
namespace wetted_line_test {

/// Wet places every centimetre along x from `from` to `to` at one y.
void wet(WettedLine& line, double y, double from, double to) {
    for (int k = 0; from + 0.01 * k < to + 1e-9; ++k) line.add_wet({from + 0.01 * k, y, 0});
}

TEST(WettedLine, IsTheKeelOfOneHull) {
    WettedLine line(1);
    wet(line, 0.02, 1.65, 4);
    wet(line, 0.4, 2.9, 4);  // the chine, wet later
    EXPECT_NEAR(line.longest(), 2.35, 1e-9);
}

TEST(WettedLine, IsTheLongerOfACatamaransKeelsAndNothingBetweenThem) {
    WettedLine line(2);
    wet(line, -0.83, 0.5, 3);
    wet(line, 0.83, 0.4, 3);
    EXPECT_NEAR(line.longest(), 2.6, 1e-9);
}

TEST(WettedLine, DoesNotJoinWhatLiesSideBySide) {
    WettedLine line(1);  // a wet patch ahead on one side, another behind on the other
    line.add_wet({0, -0.4, 0});
    line.add_wet({4, 0.4, 0});
    EXPECT_EQ(line.longest(), 0);
}

TEST(WettedLine, OfAPlaneHullIsItsOnlyLine) {
    WettedLine line(0);
    wet(line, 0, 1, 2);
    EXPECT_NEAR(line.longest(), 1, 1e-9);
    EXPECT_EQ(WettedLine(1).longest(), 0) << "dry";
}

}  // namespace wetted_line_test
}  // namespace tw
