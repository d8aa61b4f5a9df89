#include "record/influence_words.h"

#include <gtest/gtest.h>

namespace tw {
namespace influence_words_test {

TEST(InfluenceWords, ABoundSaysItsSides) {
    EXPECT_EQ(in_words({.of = "pressure", .below = 0.35, .above = 0.43}), "35 % less to 43 % more");
    EXPECT_EQ(in_words({.of = "arrival", .above = 0.14}), "up to 14 % later");
    EXPECT_EQ(in_words({.of = "arrival", .above = 0.0227, .unit = "s"}), "up to 22.7 ms later");
    EXPECT_EQ(in_words({.of = "impulse", .below = 0.23}), "up to 23 % less");
    EXPECT_EQ(in_words({.of = "height", .below = 0.02, .above = 0.02, .unit = "m"}), "±0.02 m");
}

TEST(InfluenceWords, KindsOfWhichTheSameIsSaidAreNamedTogetherAndForcesStandInTheInfluence) {
    const auto words = bounds_in_words({{.of = "drag", .below = 0.1, .above = 0.1, .source = "a page"},
                                        {.of = "peak", .below = 0.01, .above = 0.01, .source = "Ma^2"},
                                        {.of = "height", .below = 0.01, .above = 0.01, .source = "Ma^2"},
                                        {.of = "arrival", .above = 0.14, .source = "a page", .elements = "particles"}});
    ASSERT_EQ(words.size(), 2u);
    EXPECT_EQ(words[0], "peak, height: ±1 % (Ma^2)");
    EXPECT_EQ(words[1], "arrival: up to 14 % later (a page, particles alone)");
}

}  // namespace influence_words_test
}  // namespace tw
