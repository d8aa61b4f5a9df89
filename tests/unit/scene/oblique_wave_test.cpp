// A wave under an angle to a stream: how it is met, the zones at all four sides that make it, and what is refused.
#include "scene/box/oblique_wave.h"

#include <cmath>
#include <numbers>

#include "scene/box/tank_wave.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/new_record.h"
#include "scene/wave_twin.h"
#include "scene_text.h"
#include "waves/dispersion.h"

namespace tw::test {
namespace oblique_wave_test {

using std::numbers::pi;

constexpr double k = 2 * pi, depth = 0.32;

std::string stream(double degrees, double speed = 0.4) {
    return "[motion]\nkind = \"stream\"\nspeed = " + std::to_string(speed) +
           "\n[domain]\nx = [-0.5, 0.5]\ny = [-0.4, 0.4]\nz = [-0.32, 0.15]\n[water]\ndepth = 0.32\n[resolution]\n"
           "near_hull = 0.02\n[[probe]]\nname = \"G\"\nheight = [0.1, -0.2]\n[wave]\nheight = 0.08\nlength = "
           "1\ndirection = \"" +
           std::to_string(degrees) + " deg\"\ntheory = \"linear\"\n";
}

double omega() { return wave_frequency(k, 9.81, depth); }
double group() { return group_speed_ratio(k * depth) * omega() / k; }

TEST(ObliqueWave, IsMetByWhatTheStreamHasAlongItsWay) {
    for (const double degrees : {30.0, -60.0, 90.0, 120.0}) {
        const Scene s = scene_of(stream(degrees));
        const double b = degrees * pi / 180;
        ASSERT_TRUE(runs_obliquely(s));
        EXPECT_NEAR(s.wave->encounter_frequency(), omega() + 0.4 * k * std::cos(b), 1e-3);
        EXPECT_NEAR(energy_velocity(s).x(), 0.4 + group() * std::cos(b), 1e-3);
        EXPECT_NEAR(energy_velocity(s).y(), group() * std::sin(b), 1e-3);
        EXPECT_NEAR(wave_scales(s).slowest, energy_velocity(s).norm(), 1e-12);
    }
    const Scene beam = scene_of(stream(90)), head = scene_of(stream(0)), following = scene_of(stream(180, 0.44));
    EXPECT_EQ(beam.wave->sum.direction, 0);
    EXPECT_EQ(beam.wave->sum.across, 1);
    EXPECT_EQ(head.wave->sum.direction, 1);
    EXPECT_EQ(following.wave->sum.direction, -1);
    EXPECT_FALSE(runs_obliquely(head) || runs_obliquely(following));
}

TEST(ObliqueWave, IsMadeByZonesAtAllFourSides) {
    const double depth_term = std::sqrt(std::tanh(k * depth));
    for (const double degrees : {20.0, 45.0, 120.0}) {
        const Scene s = scene_of(stream(degrees));
        const double b = degrees * pi / 180, c = omega() / k,
                     x = std::cos(b) > 0 ? k * (c * std::cos(b) + 0.4)
                                         : omega() * std::abs(0.4 + group() * std::cos(b)) / group();
        const ForcingZones plan = forcing_zones(s);
        ASSERT_EQ(plan.zones.size(), 4);
        for (const ForcingZone& zone : plan.zones) {
            EXPECT_TRUE(zone.makes_wave);
            EXPECT_GE(std::abs(zone.end - zone.begin), 1.5 - 1e-9);
            const double met = std::max(zone.axis == 0 ? x : omega() * std::abs(std::sin(b)), omega() / 2);
            EXPECT_NEAR(zone.gamma, 1.5 * 1.5 * met / depth_term, 0.02) << degrees << " " << zone.axis;
        }
        EXPECT_TRUE(grown_zones(s).empty());  // cells keep their size where a wave is made
    }
    EXPECT_EQ(forcing_zones(scene_of(stream(0))).zones.size(), 2);
}

TEST(ObliqueWave, IsMeasuredOnceItHasFilledTheBox) {
    const Scene s = scene_of(stream(-60));  // from high y
    const double over_y = (s.domain.box.max.y() - s.domain.undamped.min.y()) / (group() * std::sin(pi / 3)),
                 over_x = (s.domain.undamped.max.x() - s.domain.box.min.x()) / (0.4 + group() / 2);
    EXPECT_NEAR(time_to_fill(s), std::min(over_x, over_y), 5e-3);
    EXPECT_GE(s.sampling.mean_from, s.motion.ramp + 3 * s.wave->encounter_period() + time_to_fill(s) - 1e-9);
}

TEST(ObliqueWave, IsSaidAndRecorded) {
    const Scene s = scene_of(stream(120));
    const std::string said = to_text(s, predict(s));
    for (const char* part : {"towards 120 degrees from +x to +y", "from the port quarter", "met every",
                             "all of them draw to stream and wave", "fills the box"})
        EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
    const RunRecord r = new_record(s, "sph"), head = new_record(scene_of(stream(0)), "sph");
    EXPECT_NEAR(r.numbers.at("wave_direction"), -0.5, 1e-12);
    EXPECT_NEAR(r.numbers.at("wave_across"), std::sqrt(0.75), 1e-12);
    EXPECT_EQ(r.numbers.at("height_y_G"), -0.2);
    EXPECT_FALSE(head.numbers.contains("wave_across") || head.numbers.contains("height_y_G"));
}

const std::string box_hull =
    "[hull]\nshape = \"box\"\nlength = 0.6\nbeam = 0.2\nheight = 0.3\ndraft = 0.1\n[motion]\nkind = \"stream\"\nspeed "
    "= "
    "0.4\n[domain]\nahead = 0.4\nbehind = 0.4\nside = 0.5\nbelow = 0.32\nabove = 0.3\n[resolution]\nnear_hull = "
    "0.02\nspacing = 0.02\n[wave]\nheight = 0.08\nlength = 1\ndirection = \"30 deg\"\n";

TEST(ObliqueWave, BesideAHullHasOpenSidesAndATwinWithThem) {
    Scene s = scene_of(box_hull);
    EXPECT_EQ(forcing_zones(s).zones.size(), 4);
    EXPECT_EQ(s.zones.sides, "open");
    make_wave_twin(s);
    EXPECT_EQ(s.zones.sides, "open");
    ASSERT_EQ(forcing_zones(s).zones.size(), 4);
    for (const ForcingZone& zone : forcing_zones(s).zones) EXPECT_FALSE(zone.makes_wave);
}

TEST(ObliqueWave, RefusesWhatItCannotMake) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
        EXPECT_NE(said.find("scene.toml:"), std::string::npos) << said;
    };
    refused(with(stream(30), "z = [", "dimensions = 2\nz = ["), "two dimensions have no oblique waves");
    refused(with(box_hull, "shape = ", "half = true\nshape = "), "half = false");
    refused(with(box_hull, "ahead = ", "sides = \"walls\"\nahead = "), "walls would reflect an oblique wave");
    refused(with(with(stream(30), "height = 0.08\nlength = 1\n", "significant_height = 0.05\npeak_period = 0.8\n"),
                 "theory = \"linear\"", "spectrum = \"jonswap\""),
            "sums of waves are made as head and following waves alone");
    refused(
        "[tank]\nmin = [-2, -1, -0.4]\nmax = [2, 1, 0.2]\n[resolution]\nnear_hull = 0.02\n[wave]\nheight = "
        "0.08\nlength = 1\ndirection = \"30 deg\"\n",
        "a tank's sides are walls");
    refused(stream(20, 2.1), "1.5 times the wave's speed");
    refused(stream(20, 0.1), "would leave through the inlet");
    refused(stream(150, 0.5), "144.7 degrees");  // its energy runs at 0.61 m/s along x
    EXPECT_EQ(complaint(stream(150, 0.38)), "");
    EXPECT_EQ(complaint(stream(130, 0.5)), "");  // nearer to the beam a stream may bring it from ahead
    refused(stream(130, 1.6), "carries the crests of this wave");
}

}  // namespace oblique_wave_test
}  // namespace tw::test
