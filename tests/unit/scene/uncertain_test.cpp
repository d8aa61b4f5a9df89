#include "scene/uncertain.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "base/numbers.h"
#include "tests/unit/scene/scene_text.h"

namespace tw {
namespace uncertain_test {

using namespace tw::test;

const std::string barge = R"([hull]
shape = "box"
length = "1 m"
beam = "0.4 m"
height = "0.2 m"
draft = "100 mm"
[motion]
kind = "stream"
speed = 2
[resolution]
near_hull = "40 mm"
)";
const std::string rods = R"([tank]
size = [1, 1, 1]
[[water_block]]
min = [0, 0, 0]
max = [1, 1, 0.5]
[[body]]
name = "rod"
shape = "sphere"
diameter = "0.2 m"
position = [0.3, 0.5]
draft = "50 mm"
density = 800
[[body]]
name = "ball"
shape = "sphere"
diameter = "0.2 m"
position = [0.7, 0.5]
draft = "50 mm"
density = 900
[resolution]
near_hull = "40 mm"
)";

std::vector<UncertainNumber> numbers_of(const std::string& text, const SceneOverrides& overrides = {}) {
    return uncertain_numbers(written(text), overrides);
}

TEST(UncertainInput, NumbersAreNamedByKeyAndNeedNoSectionWhereOneAloneIsMeant) {
    const auto all = numbers_of(barge + "[uncertain]\ndraft = \"1 mm\"\ntrim = \"0.1 deg\"\nhull.beam = \"2 %\"\n" +
                                "\"motion.speed\" = 0.05\nwater.density = 3\n");
    ASSERT_EQ(all.size(), 5u);
    EXPECT_EQ(all[0].name, "hull.draft");
    EXPECT_DOUBLE_EQ(all[0].value, 0.1);
    EXPECT_DOUBLE_EQ(all[0].half_width, 0.001);
    EXPECT_EQ(all[0].width, "1 mm");
    EXPECT_EQ(all[1].name, "hull.trim");  // not written in the scene: 0
    EXPECT_DOUBLE_EQ(all[1].value, 0);
    EXPECT_NEAR(all[1].half_width, 0.1 * degree, 1e-15);
    EXPECT_DOUBLE_EQ(all[2].half_width, 0.02 * 0.4);
    EXPECT_EQ(all[3].name, "motion.speed");
    EXPECT_DOUBLE_EQ(all[3].half_width, 0.05);
}

TEST(UncertainInput, TheCommandLineSpeaksFirstAndAnotherTableTakesPrecedence) {
    const auto file = written(barge + "[uncertain]\nspeed = \"1 %\"\n");
    SceneOverrides faster;
    faster.speed = 4;
    EXPECT_DOUBLE_EQ(uncertain_numbers(file, faster)[0].half_width, 0.04);
    const UncertainTable more{file, parse_document("speed = 0.5\nhull.draft = \"2 mm\"\n", "suite.toml")};
    const auto all = uncertain_numbers(file, {}, &more);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_DOUBLE_EQ(all[0].half_width, 0.5);
    EXPECT_EQ(all[1].name, "hull.draft");
}

TEST(UncertainInput, ChangedNumbersAreThoseOfTheSceneAndTheSectionIsInNoHash) {
    const Scene scene = scene_of(barge), uncertain = scene_of(barge + "[uncertain]\ndraft = \"1 mm\"\n");
    EXPECT_EQ(uncertain.hash, scene.hash);
    const auto file = written(barge);
    const Scene changed = read_scene(file, {}, {{"hull.draft", 0.12}, {"hull.trim", 1 * degree}});
    EXPECT_DOUBLE_EQ(changed.hull->draft, 0.12);
    EXPECT_NEAR(changed.hull->trim, 1 * degree, 1e-12);
    EXPECT_NE(changed.hash, scene.hash);
    EXPECT_GT(changed.hull->still.volume, scene.hull->still.volume);
}

TEST(UncertainInput, WhatCannotBeUncertainIsRefusedWithItsPlace) {
    const auto says = [](const std::string& scene, const std::string& line, const std::string& words) {
        const std::string said = complaint(scene + "[uncertain]\n" + line + "\n");
        EXPECT_NE(said.find(words), std::string::npos) << line << ": " << said;
        EXPECT_TRUE(said.starts_with("scene.toml:")) << said;
    };
    says(barge, "hull.shape = \"1 mm\"", "hull.shape = \"box\" is no number");
    says(barge, "shape = 1", "is no number");
    says(barge, "hull = \"1 mm\"", "hull");
    says(barge, "kind = 1", "is no number");
    says("title = \"5\"\n" + barge, "title = 1", "is no number");
    says(barge, "hull.draught = \"1 mm\"", "has no draught; it has: shape, length");
    says(barge, "density = \"1 s\"", "water.density = \"1 s\"");
    says(barge, "drat = \"1 mm\"", "the scene has no drat");
    says(barge, "body.rod.density = 1", "the scene has no body");
    says(barge, "resolution.near_hull = \"1 mm\"", "says how the scene is solved and recorded, not what it is");
    says(barge + "[sph]\ncfl = 0.2\n", "sph.cfl = 0.1", "belongs to the numerics of one method");
    says(barge, "draft = \"1 s\"", "s");
    says(barge, "draft = -1", "expected a half width greater than 0");
    says(barge, "draft = true", "expected a half width such as");
    says(barge, "trim = 0.1", "a plain number is in radians");
    says(barge, "trim = \"5 %\"", "per cent of a number that is 0");
    says(barge, "draft = \"1 mm\"\nhull.draft = \"2 mm\"", "it is named twice");
    says(rods, "density = 10",
         "several numbers of the scene are called density; expected one of body.rod.density, body.ball.density");
    says(rods, "tank.size = \"1 mm\"", "expected one of its entries: tank.size.1 to tank.size.3");
    EXPECT_NE(complaint("uncertain = 1\n" + barge).find("expected a section [uncertain]"), std::string::npos);
}

}  // namespace uncertain_test
}  // namespace tw
