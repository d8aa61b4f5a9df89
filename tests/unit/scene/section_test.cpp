#include "scene/read/scene_section.h"

#include "scene_text.h"

namespace tw::test {
namespace section_test {

TEST(SceneErrors, AMisspeltKeyNamesThePlaceTheKnownKeysAndTheNearest) {
    EXPECT_EQ(complaint(with(planing, "draft    =", "darft    =")),
              "scene.toml:8:1: [hull] darft = \"0.2 m\": unknown key; this section knows: axes, beam, deadrise, draft, "
              "file, free, half, heel, height, length, "
              "position, rake, repair, shape, trim, unit; did you mean 'draft'?");
    EXPECT_EQ(complaint(with(planing, "[motion]", "[motoin]")).substr(0, 66),
              "scene.toml:11:2: [motoin]: unknown section or key; the file knows:");
}

TEST(SceneErrors, WrongTypesUnitsAndRangesStandAtTheirValue) {
    const auto speed = [](const std::string& value) {
        return complaint(with(planing, "speed = \"8 m/s\"", "speed = " + value));
    };
    EXPECT_EQ(speed("\"8 m\""),
              "scene.toml:13:9: [motion] speed = \"8 m\": 'm' does not measure the right thing; expected a unit like "
              "m/s, kn, kt, mph");
    EXPECT_EQ(speed("true"),
              "scene.toml:13:9: [motion] speed = true: expected a number in m/s or a text such as \"1.5 m/s\"");
    for (const char* none : {"-3", "0"})
        EXPECT_EQ(speed(none), std::string("scene.toml:13:9: [motion] speed = ") + none +
                                   ": out of range; expected greater than 0 m/s and at most 1000 m/s (for still water "
                                   "write kind = \"none\")");
    EXPECT_EQ(complaint(with(planing, "\"5 deg\"", "5")),
              "scene.toml:7:12: [hull] trim = 5: out of range; expected from -90 deg to 90 deg (a plain number is in "
              "radians; write \"5 deg\" for degrees)");
    EXPECT_EQ(complaint(with(planing, "kind  = \"stream\"", "kind  = \"steam\"")),
              "scene.toml:12:9: [motion] kind = \"steam\": not known; expected one of: stream, none; "
              "did you mean 'stream'?");
    EXPECT_EQ(complaint(with(planing, "kind  = \"stream\"", "kind  = \"free\"")),
              "scene.toml:12:9: [motion] kind = \"free\": this version solves a fixed hull only; expected \"stream\" "
              "(uniform stream) or \"none\" (still water; solids that move are [[body]])");
    EXPECT_EQ(complaint(with(planing, "half     = true", "half     = 1")),
              "scene.toml:9:12: [hull] half = 1: expected true or false");
    EXPECT_EQ(complaint(with(planing, "near_hull = \"0.05 m\"", "near_hull = -0.05")),
              "scene.toml:16:13: [resolution] near_hull = -0.05: out of range; expected greater than 0 m");
    EXPECT_EQ(complaint(with(planing, "near_hull =", "spacing = 0.04\nnear_hull =")),
              "scene.toml:17:13: [resolution] near_hull = \"0.05 m\": coarser than spacing = 0.04 m; near_hull is the "
              "finest, spacing the coarsest size");
}

TEST(SceneErrors, BrokenTomlStandsAtItsPlace) {
    EXPECT_EQ(complaint("title = \"x\"\n[hull\nshape = 1\n").substr(0, 37), "scene.toml:2:6: not valid TOML: Error");
    EXPECT_EQ(complaint("[(hull]\n").substr(0, 31), "scene.toml:1:2: not valid TOML:");
}

TEST(SceneErrors, ACommandLineValueIsNamedByItsOption) {
    SceneOverrides still;
    still.speed = 0;
    EXPECT_EQ(complaint(planing, still),
              "scene.toml: --speed 0: out of range; expected greater than 0 m/s and at most 1000 m/s (for still water "
              "write kind = \"none\")");
    SceneOverrides absent;
    absent.hull_file = "/nowhere/hull.stl";
    EXPECT_EQ(complaint(planing, absent),
              "scene.toml: --hull \"/nowhere/hull.stl\": there is no file /nowhere/hull.stl");
}

TEST(SceneErrors, NamesFromASceneAreOnlyLettersDigitsAndUnderscores) {
    const std::string tank =
        "[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n[resolution]\nnear_hull = "
        "0.1\n[[probe]]\nheight = [0.2, 0.5]\n";
    EXPECT_EQ(complaint(tank + "name = \"H1\"\n"), "");
    for (const char* name : {"../x", "a b", "$(reboot)", "#calc", "1a", "", "x;y", "<script>"})
        EXPECT_NE(complaint(tank + "name = '" + name + "'\n").find("expected a name of letters"), std::string::npos)
            << name;
    EXPECT_NE(complaint(tank + "[[obstacle]]\nname = 'a'\nmin = [0.6, 0, 0]\nmax = [0.7, 1, 0.2]\n[[obstacle]]\nname = "
                               "'a'\nmin = [0.8, 0, 0]\nmax = [0.9, 1, 0.2]\n")
                  .find("'a' is taken already"),
              std::string::npos);
}

}  // namespace section_test
}  // namespace tw::test
