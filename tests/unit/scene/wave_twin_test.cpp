// The empty twin of a scene with bodies in a wave: what is left out, and all else the same.
#include "scene/wave_twin.h"

#include <algorithm>

#include "record/run_record.h"
#include "record/wave_twin.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/tank_wave.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene_text.h"

namespace tw::test {
namespace wave_twin_of_scene_test {

std::string box_in_waves(const std::string& wave = "", const std::string& density = "500") {
    return "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.01, 0.12]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.04\n"
           "length = 1\n" +
           wave +
           "[resolution]\nnear_hull = 0.01\n[[probe]]\nname = \"before\"\nheight = [-0.3, 0]\n[[body]]\nname = "
           "\"box\"\n"
           "shape = \"box\"\nlength = 0.2\nbeam = 1\nheight = 0.12\nposition = [0.05, 0]\ndraft = 0.06\ndensity = " +
           density + "\n";
}
Scene twin_of(const std::string& text) {
    SceneOverrides empty;
    empty.wave_twin = true;
    return scene_of(text, empty);
}

TEST(EmptyTwin, HasGaugesForBodiesAndAllElseAsWithThem) {
    const Scene s = scene_of(box_in_waves()), twin = twin_of(box_in_waves());
    EXPECT_TRUE(twin.bodies.empty());
    ASSERT_EQ(twin.sampling.height.size(), 2);
    EXPECT_EQ(twin.sampling.height[0].name, "before");
    EXPECT_EQ(twin.sampling.height[1].name, gauge_of_empty_twin("box"));
    EXPECT_NEAR(twin.sampling.height[1].x, s.bodies[0].motion.mass.centre.x(), 1e-12);
    EXPECT_NEAR(twin.sampling.height[1].x, 0.05, 1e-9);
    EXPECT_EQ(twin.run.duration, s.run.duration);
    EXPECT_EQ(twin.sampling.mean_from, s.sampling.mean_from);
    EXPECT_EQ(twin.sampling.interval, s.sampling.interval);
    EXPECT_EQ(twin.sph.c0, s.sph.c0);
    // the same steps: beside the box cells are a quarter as large
    EXPECT_NEAR(s.fvm.max_courant, 0.6, 1e-9);
    EXPECT_NEAR(twin.fvm.max_courant, 0.15, 1e-9);
    EXPECT_NEAR(twin.fvm.max_alpha_courant, s.fvm.max_alpha_courant / 4, 1e-9);
    // the wave begins where it begins with the body: in a tank without solids it would begin everywhere
    EXPECT_EQ(TankWave(twin).surface(0.3), TankWave(s).surface(0.3));
    const auto without = [](std::string text) { return text.erase(text.find("[[body]]")); };
    EXPECT_NE(TankWave(scene_of(without(box_in_waves()))).surface(0.3), TankWave(s).surface(0.3));
}

TEST(EmptyTwin, MakesTheSameStepsWithACourantNumberOfTheScene) {
    const std::string given = box_in_waves() + "[fvm]\nmax_courant = 0.4\nmax_alpha_courant = 0.2\n";
    EXPECT_NEAR(scene_of(given).fvm.max_courant, 0.4, 1e-9);
    EXPECT_NEAR(twin_of(given).fvm.max_courant, 0.1, 1e-9);
    EXPECT_NEAR(twin_of(given).fvm.max_alpha_courant, 0.05, 1e-9);
}

TEST(WaveRecord, KnowsWhereABodyStandsBetweenItsGauges) {
    const RunRecord record = new_record(scene_of(box_in_waves()), "sph");
    EXPECT_NEAR(record.numbers.at("body_x_min_box"), -0.05, 1e-6);
    EXPECT_NEAR(record.numbers.at("body_x_max_box"), 0.15, 1e-6);
    EXPECT_FALSE(new_record(twin_of(box_in_waves()), "sph").numbers.contains("body_x_min_box"));
}

TEST(EmptyTwin, KnowsTheRunThatItBelongsTo) {
    const Scene s = scene_of(box_in_waves()), twin = twin_of(box_in_waves());
    for (const char* method : {"sph", "fvm"}) {
        const RunRecord record = new_record(twin, method);
        EXPECT_EQ(record.attributes.at(std::string(wave_twin_of_run)), run_hash(s, method));
        EXPECT_FALSE(new_record(s, method).attributes.contains(std::string(wave_twin_of_run)));
        EXPECT_NE(run_hash(twin, method), run_hash(s, method));
    }
    EXPECT_NE(twin_of(box_in_waves("", "400")).hash, twin.hash) << "of another body it is run anew";
    SceneOverrides coarse;
    coarse.wave_twin = true;
    coarse.near_hull = 0.008;
    EXPECT_EQ(family_hash(scene_of(box_in_waves(), coarse), "sph"), family_hash(twin, "sph"));
}

TEST(EmptyTwin, IsWantedInTwoDimensionsWithAFreeBodyInARegularWave) {
    EXPECT_TRUE(wants_wave_twin(scene_of(box_in_waves())));
    EXPECT_TRUE(wants_wave_twin(scene_of(box_in_waves("empty_twin = \"on\"\n"))));
    EXPECT_FALSE(wants_wave_twin(scene_of(box_in_waves("empty_twin = \"off\"\n"))));
    EXPECT_FALSE(wants_wave_twin(twin_of(box_in_waves()))) << "or it would have a twin of its own";
    std::string empty = box_in_waves();
    empty.erase(empty.find("[[body]]"));
    EXPECT_FALSE(wants_wave_twin(scene_of(empty)));
    EXPECT_NE(complaint(with(empty, "length = 1\n", "length = 1\nempty_twin = \"on\"\n"))
                  .find("no free rigid body and no obstacle"),
              std::string::npos);
    EXPECT_EQ(scene_of(box_in_waves("empty_twin = \"off\"\n")).hash, scene_of(box_in_waves()).hash);
    SceneOverrides twin;
    twin.wave_twin = true;
    EXPECT_NE(complaint(with(box_in_waves(), "\"before\"", "\"without_box\""), twin)
                  .find("a height gauge is named without_box"),
              std::string::npos);
}

/// A column that stands at the wall y = 0 of a tank in three dimensions.
std::string column_in_waves(const std::string& wave = "") {
    std::string text = with(with(box_in_waves(wave), "0.01, 0.12]", "0.2, 0.12]"), "[domain]\ndimensions = 2\n", "");
    return text.erase(text.find("[[body]]")) +
           "[[obstacle]]\nname = \"column\"\nshape = \"box\"\nlength = 0.1\nbeam = 0.1\nheight = 0.5\n"
           "position = [0.05, 0, -0.25]\n";
}

TEST(EmptyTwin, LeavesObstaclesOutOnRequestWhereNoBodyIsFree) {
    const std::string on = "empty_twin = \"on\"\n";
    EXPECT_FALSE(wants_wave_twin(scene_of(column_in_waves())));
    const Scene s = scene_of(column_in_waves(on)), twin = twin_of(column_in_waves(on));
    EXPECT_TRUE(wants_wave_twin(s));
    EXPECT_FALSE(wants_wave_twin(twin));
    EXPECT_EQ(left_out_of_twin(s), "its obstacles");
    EXPECT_EQ(s.obstacles.size(), 1);
    EXPECT_TRUE(twin.obstacles.empty());
    EXPECT_EQ(twin.sampling.height.back().name, gauge_of_empty_twin("column"));
    EXPECT_NEAR(twin.sampling.height.back().x, 0.05, 1e-9);
    EXPECT_NEAR(twin.sampling.height.back().y, 0.01, 1e-9) << "a spacing inside the tank";
    EXPECT_EQ(twin.run.duration, s.run.duration);
    EXPECT_EQ(twin.sph.c0, s.sph.c0);
    EXPECT_EQ(TankWave(twin).surface(0.3), TankWave(s).surface(0.3));

    // beside a free body it stands: the body's response is that in its neighbourhood
    const std::string both = box_in_waves() +
                             "[[obstacle]]\nname = \"step\"\nshape = \"box\"\nlength = 0.1\nbeam = 0.1\n"
                             "height = 0.05\nposition = [0.45, 0, -0.24]\n";
    EXPECT_EQ(twin_of(both).obstacles.size(), 1);
    EXPECT_EQ(left_out_of_twin(scene_of(both)), "its bodies");
}

/// A hull held in a stream with a head wave, two dimensions.
std::string hull_in_waves(const std::string& wave = "") {
    return "[hull]\nshape = \"cylinder\"\ndiameter = 0.1\nspan = 1\ndraft = 0.25\n[motion]\nkind = \"stream\"\n"
           "speed = 0.6\n[domain]\ndimensions = 2\nahead = 0.8\nbehind = 0.8\nbelow = 0.4\nabove = 0.14\n[wave]\n"
           "height = 0.06\nlength = 1\n" +
           wave + "[resolution]\nnear_hull = 0.0125\n";
}

TEST(CalmTwin, HasNoWaveAndAllElseAsWithIt) {
    const Scene s = scene_of(hull_in_waves()), twin = twin_of(hull_in_waves());
    EXPECT_TRUE(wants_wave_twin(s));
    EXPECT_FALSE(twin.has_wave());
    EXPECT_FALSE(wants_wave_twin(twin));
    ASSERT_TRUE(twin.hull);
    EXPECT_EQ(twin.domain.box.min, s.domain.box.min);
    EXPECT_EQ(twin.domain.box.max, s.domain.box.max);
    EXPECT_EQ(twin.run.duration, s.run.duration);
    EXPECT_EQ(twin.sampling.mean_from, s.sampling.mean_from);
    EXPECT_EQ(twin.sph.c0, s.sph.c0);
    EXPECT_EQ(twin.sph.alpha, s.sph.alpha);
    EXPECT_EQ(twin.sph.h_over_dp, s.sph.h_over_dp);
    EXPECT_EQ(twin.fvm.max_courant, s.fvm.max_courant);
    for (const char* method : {"sph", "fvm"}) {
        EXPECT_EQ(new_record(twin, method).attributes.at(std::string(wave_twin_of_run)), run_hash(s, method));
        EXPECT_NE(run_hash(twin, method), run_hash(s, method));
    }
    const ForcingZones zones = forcing_zones(twin);
    ASSERT_EQ(zones.zones.size(), forcing_zones(s).zones.size());
    for (const ForcingZone& zone : zones.zones) EXPECT_FALSE(zone.makes_wave);
}

TEST(CalmTwin, IsMadeWhereTheSceneWantsIt) {
    EXPECT_FALSE(wants_wave_twin(scene_of(hull_in_waves("calm_twin = \"off\"\n"))));
    EXPECT_TRUE(wants_wave_twin(scene_of(hull_in_waves("calm_twin = \"on\"\n"))));
    EXPECT_NE(complaint(box_in_waves("calm_twin = \"on\"\n")).find("a hull in a stream"), std::string::npos);
    EXPECT_EQ(folder_of_wave_twin(scene_of(hull_in_waves())), calm_twins_folder);
    EXPECT_EQ(folder_of_wave_twin(scene_of(box_in_waves())), empty_twins_folder);
}

}  // namespace wave_twin_of_scene_test
}  // namespace tw::test
