// Water that runs into the zones of finer particles: how high it comes to stand, and what a run of it takes.
#include "scene/water/running_water.h"

#include <cmath>
#include <filesystem>

#include "scene/cost/time_left.h"
#include "scene/particles/cost_of_sizes.h"
#include "scene/particles/particles_of_sizes.h"
#include "scene_text.h"
#include "test_paths.h"

namespace tw::test {
namespace running_water_test {

/// A tank of 4 x 2 x 1.6 m, its water from x = 0 to `length` and to `height`.
std::string pool(const std::string& length, const std::string& height) {
    return "[tank]\nsize = [4, 2, 1.6]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [" + length + ", 2, " + height +
           "]\n[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.05\nspacing = 0.1\n[run]\nduration = 1\n";
}
const std::string post = "[[obstacle]]\nmin = [3, 0.75, 0]\nmax = [3.5, 1.25, 1]\n";

TEST(RunningWater, StandsAtItsLevelAndAtMostTwiceAsHighOrAsItFellFrom) {
    const auto low = running_water(scene_of(pool("1", "1.2"))), tall = running_water(scene_of(pool("3", "1.2")));
    ASSERT_TRUE(low && tall);
    EXPECT_NEAR(low->level, 0.3, 1e-6);
    EXPECT_NEAR(low->highest, 0.6, 1e-6);
    EXPECT_NEAR(tall->level, 0.9, 1e-6);
    EXPECT_NEAR(tall->highest, 1.2, 1e-6);
    // The post takes 0.25 m2 of the floor's 8.
    const auto round_post = running_water(scene_of(pool("1", "1.2") + post));
    ASSERT_TRUE(round_post);
    EXPECT_NEAR(round_post->level, 2.4 / 7.75, 1e-6);
    const Scene deep = scene_of(pool("3.5", "1.5") + post);  // above the post: its whole 0.25 m3
    ASSERT_TRUE(running_water(deep));
    EXPECT_NEAR(running_water(deep)->level, (10.5 + 0.25) / 8, 1e-6);
}

TEST(RunningWater, IsNoneWhereItIsLevelWithoutWeightOrInAStream) {
    EXPECT_FALSE(running_water(scene_of(pool("4", "1.2"))));
    EXPECT_FALSE(running_water(scene_of(pool("4", "1.2") + post)));
    EXPECT_FALSE(running_water(scene_of(pool("1", "1.2") + "[effects]\ngravity = \"off\"\n")));
    EXPECT_FALSE(running_water(scene_of(planing)));
    EXPECT_TRUE(running_water(scene_of(pool("3.8", "1.2"))));
}

// Nothing of what a run is predicted to take depends on the moment.
TEST(RunningWater, LevelWaterTakesAtAnyTimeWhatItDoesAtTheStart) {
    const std::string sizes = "\n[sph]\nlevels = 2\nzone = 8\n";
    for (const std::string& text : {pool("4", "1.2") + post + sizes, planing + sizes}) {
        const Scene scene = scene_of(text);
        const Prediction p = predict(scene);
        EXPECT_EQ(p.most_particles, p.particles);
        EXPECT_EQ(p.particles_at_start, p.particles);
        EXPECT_EQ(all_of(particles_of_sizes(scene, During::start)), p.particles);
        EXPECT_EQ(all_of(particles_of_sizes(scene, During::peak)), p.particles);
        EXPECT_EQ(to_text(scene, p).find("water runs into"), std::string::npos);
    }
}

TEST(RunningWater, ADryZoneIsPredictedToFillAndNoWaterIsCountedTwice) {
    const Scene scene = scene_of(pool("1", "1.2") + post + "[sph]\nlevels = 2\nzone = 8\n");
    EXPECT_EQ(particles_of_sizes(scene, During::start)[1].all(), 0);
    EXPECT_GT(particles_of_sizes(scene, During::mean)[1].active, 1000);
    EXPECT_GT(particles_of_sizes(scene, During::peak)[1].active, 1000);
    for (const During when : {During::start, During::mean, During::peak}) {
        double water = 0;
        for (const ParticlesOfSize& size : particles_of_sizes(scene, when))
            water += size.active * std::pow(size.spacing, 3);
        EXPECT_NEAR(water, 2.4, 1e-9);
    }
    const Prediction p = predict(scene);
    EXPECT_LT(p.particles_at_start, 0.5 * p.particles);
    EXPECT_LT(p.particles, p.most_particles);
    double bytes = 0, seconds = 0;
    for (const CostOfSize& size : cost_of_sizes(scene, p, p.of("sph"))) bytes += size.bytes, seconds += size.seconds;
    EXPECT_NEAR(bytes, p.of("sph").bytes - p.raster_bytes, 1e-9 * bytes);
    EXPECT_NEAR(seconds, p.of("sph").seconds, 1e-9 * seconds);
    EXPECT_NE(to_text(scene, p).find("water runs into the finer zones"), std::string::npos);
}

TEST(RunningWater, NoZoneHoldsMoreThanAllOfIt) {
    const std::string middle =
        "[[obstacle]]\nmin = [1.5, 0.5, 0]\nmax = [2.5, 1.5, 0.02]\n[sph]\nlevels = 2\nzone = 14\n";
    const std::vector<ParticlesOfSize> most = particles_of_sizes(scene_of(pool("1", "1.2") + middle), During::peak);
    EXPECT_NEAR(most[1].active * std::pow(0.05, 3), 2.4, 1e-9);  // twice its level over 2.4 m of the tank would be 2.9
    EXPECT_NEAR(most[0].active, 0, 1e-6);
}

// Water that stands in the zone already and runs out of it needs memory for the start.
TEST(RunningWater, NeverNeedsLessMemoryThanTheStart) {
    std::string over_the_post = pool("4", "1.2") + post + "[sph]\nlevels = 2\nzone = 8\n";
    over_the_post.replace(over_the_post.find("min = [0, 0, 0]"), 15, "min = [2.6, 0, 0]");
    const Prediction p = predict(scene_of(over_the_post));
    EXPECT_LT(p.particles, p.particles_at_start);
    EXPECT_GE(p.most_particles, p.particles_at_start);
}

// SPHERIC's second test, a dam break against a box in a dry zone. Found: with particles of 10, 20 and 40 mm 10 850 at the
// start, 243 691 at 1.62 s and 147 800 at 3.3 s, falling; of 20 and 40 mm at most 39 000 that are active, and 358 s of
// one core (docs/results/dam_break_pressure.md) with an engine that made 1.1 million particle steps a second, where that of the
// table makes 2.86 million.
TEST(RunningWater, OfSphericsDamBreakIsPredictedAsItWasFound) {
    const auto spheric = [](double near_hull) {
        SceneOverrides sizes;
        sizes.near_hull = near_hull;
        sizes.spacing = 0.04;
        Scene scene = read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies" / "spheric02.toml", sizes);
        scene.run.threads = 1;
        return scene;
    };
    const Scene fine = spheric(0.01), coarse = spheric(0.02);
    const Prediction p = predict(fine), q = predict(coarse);
    EXPECT_NEAR(p.particles_at_start / 10850, 1, 0.05);
    EXPECT_GT(p.most_particles, 243691);
    EXPECT_LT(p.most_particles, 1.4 * 243691);
    EXPECT_NEAR(p.particles / 147800, 1, 0.15);
    double active = 0;
    for (const ParticlesOfSize& size : particles_of_sizes(coarse, During::peak)) active += size.active;
    EXPECT_GT(active, 39000);
    EXPECT_LT(active, 1.4 * 39000);
    EXPECT_NEAR(q.of("sph").seconds / (358 * 1.1 / 2.86), 1, 0.25);
}

// A run that goes on evenly is told its time; one that is slow to begin at first as predicted, then as found.
TEST(RunningWater, TimeLeftIsPredictedFirstAndMeasuredThen) {
    EXPECT_DOUBLE_EQ(time_left(0, 1, 0, 100), 100);
    EXPECT_DOUBLE_EQ(time_left(0.1, 0.9, 10, 100), 90);
    EXPECT_NEAR(time_left(1e-4, 1, 1, 100), 100, 5.1);
    EXPECT_DOUBLE_EQ(time_left(0.5, 0.5, 500, 100), 500);
    EXPECT_DOUBLE_EQ(time_left(0.1, 0.9, 10, 0), 90);  // nothing was predicted
    EXPECT_GT(time_left(0.1, 0.9, 32, 1600), 0.4 * 1600);
}

}  // namespace running_water_test
}  // namespace tw::test
