// What check says of blocks of water, and where a body afloat keeps the particles at one size.
#include "scene/water/water_at_start.h"

#include "scene/water/afloat.h"
#include "scene/water/water_blocks.h"
#include "scene_text.h"

namespace tw::test {
namespace water_at_start_test {

/// A flat tank of 0.4 x 0.5 m at 5 mm; each block and solid: x from, z from, x to, z to.
std::string tank_of(const std::vector<std::array<double, 4>>& blocks,
                    const std::vector<std::array<double, 4>>& solids) {
    std::string text =
        "[tank]\nsize = [0.4, 0.005, 0.5]\n[domain]\ndimensions = 2\n[motion]\nkind = \"none\"\n"
        "[resolution]\nnear_hull = 0.005\n[run]\nduration = 0.1\n";
    const auto add = [&](const char* section, const std::array<double, 4>& b) {
        text += std::string(section) + "\nmin = [" + std::to_string(b[0]) + ", 0, " + std::to_string(b[1]) +
                "]\nmax = [" + std::to_string(b[2]) + ", 0.005, " + std::to_string(b[3]) + "]\n";
    };
    for (const auto& b : blocks) add("[[water_block]]", b);
    for (const auto& b : solids) add("[[obstacle]]", b);
    return text;
}

std::string said_of(const std::vector<std::array<double, 4>>& blocks,
                    const std::vector<std::array<double, 4>>& solids = {}) {
    std::string all;
    for (const std::string& sentence : water_at_start(scene_of(tank_of(blocks, solids)))) all += sentence + "\n";
    return all;
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(WaterAtStart, IsOneWaterHoweverItIsWritten) {
    EXPECT_EQ(said_of({{0, 0, 0.4, 0.3}}), "") << "a lone block between walls needs no words";
    EXPECT_EQ(said_of({{0, 0, 0.4, 0.1}, {0, 0.1, 0.4, 0.3}}), "x 0 to 0.4, z 0 to 0.3 m: at rest, level z = 0.3 m\n");
    EXPECT_EQ(said_of({{0, 0.1, 0.1, 0.3}, {0.3, 0.1, 0.4, 0.3}, {0, 0, 0.4, 0.1}}, {{0.1, 0.1, 0.3, 0.4}}),
              "x 0 to 0.4, z 0 to 0.3 m: at rest, level z = 0.3 m\n");
    const Scene overlapping = scene_of(tank_of({{0, 0, 0.4, 0.2}, {0, 0.1, 0.4, 0.3}}, {}));
    EXPECT_NEAR(water_volume(overlapping), 0.4 * 0.3 * overlapping.span(), 1e-9) << "counted once";
}

TEST(WaterAtStart, SaysWhatIsNotAtRest) {
    EXPECT_TRUE(has(said_of({{0, 0, 0.2, 0.3}}), "released where no wall holds it"));
    EXPECT_FALSE(has(said_of({{0, 0, 0.2, 0.3}}, {{0.2, 0, 0.21, 0.4}}), "released")) << "a gate holds it";
    EXPECT_TRUE(has(said_of({{0, 0, 0.4, 0.1}, {0, 0.1, 0.1, 0.3}, {0.3, 0.1, 0.4, 0.2}}, {{0.1, 0.1, 0.3, 0.4}}),
                    "surfaces from z = 0.2 to 0.3 m are connected"));
    // a wall far thinner than a particle parts two waters
    const std::string parted = said_of({{0, 0, 0.4, 0.2}}, {{0.2, 0, 0.2005, 0.4}});
    EXPECT_TRUE(has(parted, "x 0 to 0.2, z 0 to 0.2 m: at rest"));
    EXPECT_TRUE(has(parted, "x 0.2 to 0.4, z 0 to 0.2 m: at rest"));
}

TEST(WaterAtStart, SaysWhatParticlesOfThisSizeCannotShow) {
    EXPECT_TRUE(has(said_of({{0, 0, 0.4, 0.1}, {0, 0.102, 0.4, 0.3}}), "blocks 1 and 2 are 0.002 m apart"));
    EXPECT_TRUE(has(said_of({{0, 0, 0.4, 0.1}, {0, 0.102, 0.4, 0.3}}), "at rest, level z = 0.3 m"));
    EXPECT_TRUE(has(said_of({{0, 0, 0.4, 0.1}, {0.1, 0.3, 0.2, 0.302}}), "thinner than half a particle"));
}

const std::string pool =
    "[tank]\nmin = [-0.5, 0, -0.5]\nmax = [0.5, 0.01, 0.3]\n[domain]\ndimensions = 2\n"
    "[motion]\nkind = \"none\"\n[run]\nduration = 1\n[[body]]\nshape = \"box\"\nlength = 0.3\n"
    "height = 0.2\ndraft = 0.1\n";
const std::string sizes = "[resolution]\nnear_hull = 0.01\nspacing = 0.04\n";

TEST(BodyAfloat, KeepsTheParticlesAtOneSizeUnlessTheSceneAsksForMore) {
    const Scene afloat = scene_of(pool + "density = 500\n" + sizes);
    EXPECT_TRUE(carries_a_body(afloat));
    EXPECT_EQ(afloat.sph.levels, 1);
    EXPECT_TRUE(has(why_one_size_afloat(afloat), "[sph] levels overrides this"));
    const Scene asked = scene_of(pool + "density = 500\n" + sizes + "[sph]\nlevels = 2\n");
    EXPECT_EQ(asked.sph.levels, 2);
    EXPECT_EQ(why_one_size_afloat(asked), "");
    for (const std::string other : {"density = 2000\n", "density = 500\nvelocity = [0, 0, -2]\n"}) {
        const Scene scene = scene_of(pool + other + sizes);
        EXPECT_FALSE(carries_a_body(scene)) << other << ": sinks, or is thrown in";
        EXPECT_GT(scene.sph.levels, 1);
        EXPECT_EQ(why_one_size_afloat(scene), "");
    }
}

}  // namespace water_at_start_test
}  // namespace tw::test
