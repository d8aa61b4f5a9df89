// Sums of linear waves in a tank: what a scene may ask for, its zones, what it begins with and what it tells the record.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/box/forcing_zones.h"
#include "scene/box/tank_wave.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene/summary/wave_text.h"
#include "scene_text.h"

namespace tw::test {
namespace sea_test {

std::string tank(const std::string& wave, const std::string& more = "", const std::string& low = "-4") {
    return "[tank]\nmin = [" + low + ", 0, -0.4]\nmax = [4, 0.02, 0.2]\n[domain]\ndimensions = 2\n[wave]\n" + wave +
           "[resolution]\nnear_hull = 0.0125\n" + more;
}
const std::string
    jonswap = "spectrum = \"jonswap\"\nsignificant_height = 0.06\npeak_period = 1\n",
    two = "spectrum = \"bichromatic\"\nheight = 0.04\nperiod = 1\nsecond_height = 0.03\nsecond_period = 0.8\n",
    focused = "spectrum = \"focused\"\ncrest = 0.06\npeak_period = 1\n";

TEST(SeaOfScene, HasZonesForTheLongestWavesThatCount) {
    for (const bool back : {false, true}) {
        const Scene s = scene_of(tank(jonswap + (back ? "direction = \"180 deg\"\n" : "")));
        ASSERT_TRUE(s.sea);
        EXPECT_FALSE(s.wave);
        EXPECT_TRUE(s.effect_on("forcing_zones"));
        EXPECT_EQ(s.sph.alpha, 0.001);
        const ForcingZones plan = forcing_zones(s);
        ASSERT_EQ(plan.zones.size(), 2);
        double below = 0;  // energy in waves longer than those of the zones
        for (int n = 0; n < s.sea->waves.count; ++n)
            if (s.sea->length(n) > plan.wave_length * (1 + 1e-9)) below += s.sea->energy(n) / s.sea->moment(0);
        EXPECT_LT(below, 0.05);
        EXPECT_GT(below, 0.02);
        for (const ForcingZone& z : plan.zones) {
            EXPECT_EQ(z.makes_wave, z.high == back);
            EXPECT_NEAR(std::abs(z.end - z.begin), (z.makes_wave ? 1.5 : 1) * plan.wave_length, 1e-9);
        }
        // run: three peak periods, then one in which the sea goes through all it has
        EXPECT_NEAR(s.run.duration - s.sampling.mean_from, s.sea->repeat_period, 1e-9);
    }
}

TEST(SeaOfScene, IsTheSameAtEverySizeAndOfItsSeed) {
    const Scene s = scene_of(tank(jonswap));
    EXPECT_EQ(scene_of(tank(jonswap + "seed = 1\n")).hash, s.hash);
    EXPECT_NE(scene_of(tank(jonswap + "seed = 2\n")).hash, s.hash);
    SceneOverrides larger;
    larger.scale_resolution = std::numbers::sqrt2 / 1.1;
    const Scene coarse = scene_of(tank(focused), larger), fine = scene_of(tank(focused));
    EXPECT_EQ(coarse.sea->focus_place, fine.sea->focus_place);
    EXPECT_EQ(coarse.sea->focus_time, fine.sea->focus_time);
}

TEST(SeaOfScene, MovesWaterToItsSurfaceAndKeepsItsVolume) {
    for (const std::string& wave : {jonswap, two, focused}) {
        const Scene s = scene_of(tank(wave));
        const TankWave begin(s);
        double raised = 0;
        const WaveComponents& waves = s.sea->waves;
        const double steepest = *std::max_element(waves.k, waves.k + waves.count);
        for (double x = -4 + 0.002; x < 4; x += 0.004) raised += 0.004 * begin.surface(x);
        EXPECT_NEAR(raised, 0, 1e-5);
        for (double x = -3.9; x < 4; x += 0.31) {
            const Vec3 top = begin.moved({x, 0, 0});
            EXPECT_NEAR(top.z(), begin.surface(top.x()), 1e-9);
            // first order: what is left at the surface is of the order k eta^2
            EXPECT_NEAR(begin.pressure_head(top.x(), top.z()), 0, 2 * steepest * top.z() * top.z() + 1e-3);
        }
        double u, w;
        wave_velocity(wave_moment(s.sea->waves, 0), -1, -0.1, u, w);
        EXPECT_NEAR((begin.velocity(-1, -0.1) - Vec3(u, 0, w)).norm(), 0,
                    1e-12 + (1 - begin.share(-1)) * Vec3(u, 0, w).norm());
        EXPECT_EQ(begin.velocity(4, -0.1).norm(), 0);
    }
}

TEST(SeaOfScene, FocusesAfterTheSlowestWavesCame) {
    const Scene empty = scene_of(tank(focused));
    EXPECT_NEAR(empty.sea->focus_time, 4, 1e-12);
    const ForcingZones plan = forcing_zones(empty);
    EXPECT_NEAR(empty.sea->focus_place, (plan.zones[0].begin + plan.zones[1].begin) / 2, 1e-9);
    const std::string wall = "[[obstacle]]\nmin = [1, 0, -0.1]\nmax = [1.1, 0.02, 0.05]\n";
    const Scene s = scene_of(tank(focused, wall));
    // beside solids it begins in the zone, which grows it over its whole width
    const double least = (s.sea->focus_place - plan.zones[0].end) / wave_scales(s).slowest;
    EXPECT_NEAR(s.sea->focus_time, 4 + least, 1e-9);
    const auto at = [&](double time) { return tank(focused + "focus_time = " + std::to_string(time) + "\n", wall); };
    EXPECT_EQ(complaint(at(1.01 * least)), "");
    EXPECT_NE(complaint(at(0.99 * least)).find("through the zone that makes them"), std::string::npos);
    EXPECT_GT(s.run.duration, s.sea->focus_time);
    EXPECT_NE(complaint(tank(focused + "focus_time = 29\n")).find("earlier group"), std::string::npos);
    EXPECT_NE(complaint(tank(focused + "focus_place = 3.9\n")).find("between the"), std::string::npos);
}

TEST(SeaOfScene, TellsTheRecordAndCheckWhatItIs) {
    const std::string gauge = "[[probe]]\nname = \"g\"\nheight = [0, 0]\n";
    const RunRecord record = new_record(scene_of(tank(focused + "focus_place = 0\n", gauge)), "sph");
    EXPECT_EQ(record.attributes.at("sea"), "focused");
    EXPECT_NEAR(record.numbers.at("sea_crest_first_g"), 0.06, 1e-9);
    EXPECT_GT(record.numbers.at("sea_crest_second_g"), 0.063);
    EXPECT_EQ(
        std::count(record.attributes.at("sea_components").begin(), record.attributes.at("sea_components").end(), '\n'),
        60);
    EXPECT_GT(record.numbers.at("sea_left_out"), 0.02);
    EXPECT_FALSE(record.numbers.contains("wave_period"));
    const std::string text = wave_text(scene_of(tank(jonswap)));
    for (const char* part :
         {"JONSWAP, significant height 0.06 m", "repeats itself after 30 s", "of first order", "of 60 linear waves"})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(SeaOfScene, RefusesWhatItCannotMake) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_NE(said.find("scene.toml:"), std::string::npos) << said;
    };
    refused(tank("spectrum = \"jonswap\"\npeak_period = 1\n"), "needs its significant height");
    refused(tank("spectrum = \"jonswap\"\nsignificant_height = 0.06\n"), "period of its peak");
    refused(tank(jonswap + "height = 0.1\n"), "is not used with spectrum");
    refused(tank(jonswap + "theory = \"linear\"\n"), "is not used with spectrum");
    refused(tank("height = 0.04\nlength = 1\nseed = 3\n"), "is not used with spectrum = \"regular\"");
    refused(tank("spectrum = \"pierson-moskowitz\"\nsignificant_height = 0.06\npeak_period = 1\npeakedness = 2\n"),
            "is not used");
    refused(tank("spectrum = \"jonswap\"\nsignificant_height = 0.12\npeak_period = 1\n"), "would break");
    refused(tank("spectrum = \"bichromatic\"\nheight = 0.04\nperiod = 1\nsecond_height = 0.03\nsecond_period = 1.01\n"),
            "differ by 2 %");
    refused(tank(jonswap, "", "-1"), "at the peak between");
    refused(tank("spectrum = \"jonswap\"\nsignificant_height = 0.04\npeak_period = 1\n"), "near_hull at most");
    refused(tank("spectrum = \"jonswap\"\nsignificant_height = 0.06\npeak_period = 9\n"), "no sum of linear waves");
}

}  // namespace sea_test
}  // namespace tw::test
