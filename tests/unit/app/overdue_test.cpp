#include "app/progress/overdue.h"

#include <gtest/gtest.h>

namespace tw::app {
namespace overdue_test {

/// Of a run of 10 s that was predicted to take 100 s: after so many seconds of steps at `pace` simulated seconds a
/// second.
Progress after(double wall, double pace, long steps = 1000) {
    return {.time = wall * pace, .duration = 10, .wall = wall, .steps = steps, .note = {}};
}

TEST(Overdue, ARunOfThreeTimesItsPredictionSaysSoOnceAfterItsFirstMinute) {
    Overdue overdue(100);
    EXPECT_EQ(overdue.look(after(0.1, 0)), "");
    EXPECT_EQ(overdue.look(after(59, 0.025)), "") << "it has a minute";
    const std::string said = overdue.look(after(61, 0.025));
    EXPECT_NE(said.find("4 times the predicted"), std::string::npos) << said;
    EXPECT_EQ(overdue.look(after(300, 0.025)), "") << "once";
}

TEST(Overdue, ARunOfTwiceItsPredictionSaysNothing) {
    Overdue overdue(100);
    for (double wall = 0; wall < 200; wall += 10) EXPECT_EQ(overdue.look(after(wall, 0.05)), "") << wall;
}

TEST(Overdue, MeshingAndWhatWasComputedBeforeDoNotCount) {
    Overdue overdue(100);
    for (double wall = 0; wall < 300; wall += 10) EXPECT_EQ(overdue.look(after(wall, 0, 0)), "") << "meshing";
    // resumed at 8 of 10 s, and as fast as predicted from there
    EXPECT_EQ(overdue.look({.time = 8, .duration = 10, .wall = 300, .steps = 5000, .note = {}}), "");
    EXPECT_EQ(overdue.look({.time = 14.2, .duration = 10, .wall = 362, .steps = 6000, .note = {}}), "");
    Overdue slow(100);
    EXPECT_EQ(slow.look({.time = 8, .duration = 10, .wall = 300, .steps = 5000, .note = {}}), "");
    EXPECT_NE(slow.look({.time = 8.5, .duration = 10, .wall = 362, .steps = 5100, .note = {}}), "")
        << "its steps alone count";
}

TEST(Overdue, NothingIsSaidWhereNothingWasPredicted) {
    Overdue overdue(0);
    overdue.look(after(0, 0));
    EXPECT_EQ(overdue.look(after(100, 0.001)), "");
}

}  // namespace overdue_test
}  // namespace tw::app
