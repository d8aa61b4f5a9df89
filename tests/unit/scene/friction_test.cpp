// Friction of a hull by the line for flat plates: when it is on, and how much it is.
#include <gtest/gtest.h>

#include "scene/solids/friction_line.h"
#include "scene_text.h"

namespace tw::test {
namespace friction_test {

TEST(Friction, IsOnForAHullInAFastStreamThatSolvesNone) {
    EXPECT_TRUE(scene_of(planing).effect_on("friction"));
    EXPECT_FALSE(scene_of(planing + "[effects]\nviscosity = \"on\"\n").effect_on("friction"));
    EXPECT_FALSE(scene_of(planing + "[water]\nviscosity = 1e-3\n").effect_on("friction"));  // Re = 18 000
    EXPECT_NE(complaint(planing + "[effects]\nviscosity = \"on\"\nfriction = \"on\"\n").find("together with viscosity"),
              std::string::npos);
    EXPECT_NE(complaint("[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n"
                        "[resolution]\nnear_hull = 0.05\n[effects]\nfriction = \"on\"\n")
                  .find("hull in a stream"),
              std::string::npos);
}

// A plate of 3 m and 2 m2 at 8 m/s in water of 1e-6 m2/s: Re = 2.4e7, C_F = 0.075 / 5.380211^2.
TEST(Friction, OfAPlateIsTheLineItself) {
    const Scene s = scene_of(planing + "[water]\ndensity = 1000\nviscosity = 1e-6\n");
    EXPECT_NEAR(friction_by_line(s, 2, 3), 0.5 * 1000 * 64 * 2 * 0.075 / (5.380211242 * 5.380211242), 1e-3);
    EXPECT_EQ(friction_by_line(s, 0, 3), 0);
    EXPECT_EQ(friction_by_line(s, 2, 0), 0);
    EXPECT_EQ(friction_by_line(scene_of(planing + "[effects]\nfriction = \"off\"\n"), 2, 3), 0);
}

}  // namespace friction_test
}  // namespace tw::test
