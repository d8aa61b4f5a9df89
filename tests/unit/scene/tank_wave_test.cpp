// A regular wave in a tank: what a scene may ask for, what it begins with, and where it is made and absorbed.
#include "scene/box/tank_wave.h"

#include <cmath>
#include <numbers>

#include "scene/box/forcing_zones.h"
#include "scene/hash.h"
#include "scene_text.h"

namespace tw::test {
namespace tank_wave_test {

std::string tank(const std::string& wave = "height = 0.04\nlength = 1\n", const std::string& more = "") {
    return "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.01, 0.12]\n[domain]\ndimensions = 2\n[wave]\n" + wave +
           "[resolution]\nnear_hull = 0.01\n" + more;
}

TEST(TankWave, HasAZoneThatMakesItAndOneThatAbsorbsIt) {
    for (const bool back : {false, true}) {
        const Scene s = scene_of(
            tank(back ? "height = 0.04\nlength = 1\ndirection = \"180 deg\"\n" : "height = 0.04\nlength = 1\n"));
        ASSERT_TRUE(s.wave);
        EXPECT_TRUE(s.effect_on("forcing_zones"));
        EXPECT_EQ(s.wave->sum.direction, back ? -1 : 1);
        const ForcingZones plan = forcing_zones(s);
        ASSERT_EQ(plan.zones.size(), 2);
        for (const ForcingZone& z : plan.zones) {
            EXPECT_EQ(z.axis, 0);
            EXPECT_EQ(z.makes_wave, z.high == back);
            EXPECT_NEAR(std::abs(z.end - z.begin), z.makes_wave ? 1.5 : 1, 1e-12);
            const double gamma = 1.5 * plan.frequency / std::sqrt(std::tanh(s.wave->k() * 0.24));
            EXPECT_NEAR(z.gamma, z.makes_wave ? 2 * gamma : gamma, 1e-9);
        }
        EXPECT_NEAR(plan.frequency, 2 * std::numbers::pi / s.wave->encounter_period(), 1e-9);
    }
}

TEST(TankWave, MovesWaterWithoutChangingAnyVolume) {
    const Scene s = scene_of(tank());
    const TankWave wave(s);
    const double d = 1e-4;
    for (double x = -1.9; x < 1.5; x += 0.17)
        for (double z = -0.2; z < 0; z += 0.09) {
            const Vec3 right = wave.moved({x + d, 0, z}), left = wave.moved({x - d, 0, z}),
                       up = wave.moved({x, 0, z + d}), down = wave.moved({x, 0, z - d});
            const double area =
                ((right - left).x() * (up - down).z() - (right - left).z() * (up - down).x()) / (4 * d * d);
            EXPECT_NEAR(area, 1, 2e-3) << x << " " << z;
        }
    // water at the surface comes to the surface of the wave, that at floor and walls stays there
    for (double x = -2; x <= 1.6; x += 0.1) {
        const Vec3 top = wave.moved({x, 0, 0});
        EXPECT_NEAR(top.z(), wave.surface(top.x()), 1e-9);
        EXPECT_NEAR(wave.moved({x, 0, -0.24}).z(), -0.24, 1e-12);
        EXPECT_NEAR(wave.pressure_head(top.x(), top.z()), 0, 2e-4);
    }
    EXPECT_NEAR(wave.moved({-2, 0, 0}).x(), -2, 1e-9);
    EXPECT_NEAR(wave.moved({1.6, 0, 0}).x(), 1.6, 1e-9);
    // between the zones it is the whole wave, at the far wall none is left
    double u, w;
    wave_velocity(s.wave->sum, 0.2, -0.1, 0, u, w);
    EXPECT_NEAR((wave.velocity(0.2, -0.1) - Vec3(u, 0, w)).norm(), 0, 1e-12);
    EXPECT_EQ(wave.velocity(1.6, -0.1).norm(), 0);
}

TEST(TankWave, BeginsInItsZoneAloneWhereSolidsStandInTheTank) {
    for (const char* low :
         {"-2", "-2.3"}) {  // phases of the wave at the wall in which it raises and lowers the mean level
        const Scene s = scene_of(
            with(tank("height = 0.04\nlength = 1\n", "[[obstacle]]\nmin = [0, 0, -0.1]\nmax = [0.1, 0.01, 0.05]\n"),
                 "min = [-2,", std::string("min = [") + low + ","));
        const TankWave wave(s);
        EXPECT_EQ(wave.share(std::stod(low)), 1);
        EXPECT_EQ(wave.share(0), 0);
        EXPECT_NEAR((wave.moved({0.5, 0, -0.1}) - Vec3(0.5, 0, -0.1)).norm(), 0, 1e-9) << low;
        EXPECT_EQ(wave.surface(0.5), 0);
    }
}

TEST(TankWave, IsPartOfTheHashAndNothingIsWithoutIt) {
    const std::string still = with(tank(), "[wave]\nheight = 0.04\nlength = 1\n", "");
    EXPECT_FALSE(scene_of(still).wave);
    EXPECT_FALSE(scene_of(still).effect_on("forcing_zones"));
    EXPECT_NE(scene_of(tank()).hash, scene_of(still).hash);
    EXPECT_NE(scene_of(tank()).hash, scene_of(tank("height = 0.05\nlength = 1\n")).hash);
    EXPECT_NE(scene_of(tank()).hash, scene_of(tank("height = 0.04\nlength = 1\ndirection = \"180 deg\"\n")).hash);
}

TEST(TankWave, RefusesWhatItCannotMake) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_NE(said.find("scene.toml:"), std::string::npos) << said;
    };
    refused(tank("length = 1\n"), "needs its height");
    refused(tank("height = 0.04\n"), "length or its period");
    refused(tank("height = 0.04\nlength = 1\nperiod = 0.8\n"), "one of the two");
    refused(tank("height = 0.14\nlength = 1\n"), "would break");
    refused(tank("height = 0.04\nlength = 1.2\n"), "at least 4.2 m");
    refused(tank("height = 0.04\nlength = 1\ndirection = \"30 deg\"\n"), "oblique");
    refused(tank("height = 0.02\nlength = 1\n"), "near_hull at most");
    refused(tank() + "[effects]\nforcing_zones = \"off\"\n", "made and absorbed by them");
    refused(tank() + "[[water_block]]\nmin = [-1, 0, -0.2]\nmax = [1, 0.01, 0]\n", "remove the blocks");
    refused(tank("height = 0.04\nlength = 1\n", "[[obstacle]]\nmin = [-1, 0, -0.1]\nmax = [-0.9, 0.01, 0.05]\n"),
            "stands in the zone");
    refused(with(tank(), "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.01, 0.12]\n[domain]\n",
                 "[domain]\nx = [-2, 1.6]\ny = [0, 0.01]\nz = [-0.24, 0.12]\n"),
            "in a tank between walls or in a stream");
}

TEST(TankWave, ArtificialViscosityTakesWhatTheTableSays) {
    // kd 1, 100 spacings in two dimensions, c0 = 10 sqrt(2 g d): 3.15 % a wave length
    const double d = 1 / (2 * std::numbers::pi);
    const Scene s =
        scene_of("[tank]\nmin = [-2, 0, " + std::to_string(-d) +
                 "]\nmax = [1.6, 0.01, 0.1]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.04\nlength = 1\n"
                 "theory = \"linear\"\n[resolution]\nnear_hull = 0.01\n[sph]\nh_over_dp = 1.55\nalpha = 0.01\n");
    EXPECT_NEAR(loss_by_artificial_viscosity(s, 1), 0.0315, 5e-4);
}

}  // namespace tank_wave_test
}  // namespace tw::test
