// Zones that absorb waves: where they lie, how wide and strong they are, and in which scenes.
#include "scene/box/forcing_zones.h"

#include <cmath>
#include <numbers>

#include "scene/hash.h"
#include "scene_text.h"

namespace tw::test {
namespace forcing_zones_test {

using std::numbers::pi;

/// Water 0.2 m deep.
std::string channel(const std::string& speed, const std::string& more = "") {
    return "[motion]\nkind = \"stream\"\nspeed = \"" + speed +
           "\"\n[domain]\nx = [-2, 2.5]\ny = [0, 0.01]\nz = [-0.2, 0.1]\ndimensions = 2\n[water]\ndepth = 0.2\n"
           "[resolution]\nnear_hull = 0.01\n" +
           more;
}

/// A displacement hull, 4 m long.
std::string ship(const std::string& speed, const std::string& more = "") {
    return with(with(planing, "8 m/s", speed), "duration = \"1.5 s\"\n", "") + more;
}

const ForcingZone& at(const ForcingZones& plan, int axis, bool high) {
    for (const ForcingZone& z : plan.zones)
        if (z.axis == axis && z.high == high) return z;
    throw std::logic_error("no such zone");
}
double width(const ForcingZone& z) { return std::abs(z.end - z.begin); }

TEST(ForcingZones, TheStandingWaveIsAsFastAsTheStream) {
    for (const double U : {0.05, 0.7, 1.3}) {
        const double k = 2 * pi / standing_wave_length(U, 9.81, 0.2).value();
        EXPECT_NEAR(9.81 / k * std::tanh(k * 0.2), U * U, 1e-10 * U * U) << U;
    }
    EXPECT_NEAR(standing_wave_length(1, 9.81, 50).value(), 2 * pi / 9.81, 1e-12);
    EXPECT_FALSE(standing_wave_length(std::sqrt(9.81 * 0.2), 9.81, 0.2));
    EXPECT_FALSE(standing_wave_length(3, 9.81, 0.2));
}

TEST(ForcingZones, OfASlowChannelLieOutsideTheBoxThatWasAskedFor) {
    const Scene s = scene_of(channel("0.7 m/s"));
    const ForcingZones plan = forcing_zones(s);
    ASSERT_EQ(plan.zones.size(), 2);
    const double lambda = standing_wave_length(0.7, 9.81, 0.2).value();
    EXPECT_EQ(plan.wave_length, lambda);
    EXPECT_EQ(plan.speed, 0.7);
    const ForcingZone &in = at(plan, 0, false), &out = at(plan, 0, true);
    EXPECT_NEAR(in.begin, -2, 1e-12);
    EXPECT_NEAR(out.begin, 2.5, 1e-12);
    EXPECT_EQ(in.end, s.domain.box.min.x());
    EXPECT_EQ(out.end, s.domain.box.max.x());
    EXPECT_NEAR(width(in), lambda, 0.01);  // a spacing
    EXPECT_NEAR(width(out), 1.5 * lambda, 0.01);
    EXPECT_GE(width(in), lambda);
    for (const ForcingZone& z : plan.zones) EXPECT_NEAR(z.gamma, 9.81 / 0.7, 1e-12);
    const Scene without = scene_of(channel("0.7 m/s", "[effects]\nforcing_zones = \"off\"\n"));
    EXPECT_EQ(without.domain.box.min.x(), -2);
    EXPECT_TRUE(forcing_zones(without).zones.empty());
    EXPECT_EQ(s.run.duration, without.run.duration);
    EXPECT_EQ(s.sph.c0, without.sph.c0);
    EXPECT_EQ(s.sampling.raster.count[0], without.sampling.raster.count[0]);
    EXPECT_NE(s.hash, without.hash);
}

TEST(ForcingZones, AreAbsentWhereNoWaveStandsAndChangeNoHashThere) {
    for (const std::string& text : {planing, planing + "[domain]\nbelow = 10\n", channel("1.5 m/s"),
                                    channel("0.7 m/s", "[effects]\ngravity = \"off\"\n")}) {
        const Scene s = scene_of(text);
        EXPECT_FALSE(s.effect_on("forcing_zones")) << text;
        EXPECT_EQ(s.domain.box.min, s.domain.undamped.min);
        EXPECT_EQ(s.domain.box.max, s.domain.undamped.max);
        SceneOverrides off;
        off.effects = {{"forcing_zones", false}};
        EXPECT_EQ(scene_of(text, off).hash, s.hash);
        // records of versions that called the effect so are found again
        EXPECT_NE(canonical_text(s).find("effect.damping_layers 0\n"), std::string::npos);
    }
}

TEST(ForcingZones, OfAShipLieAheadBehindAndBeside) {
    const Scene s = scene_of(ship("1.879 m/s"));  // Froude number 0.3
    const ForcingZones plan = forcing_zones(s);
    ASSERT_EQ(plan.zones.size(), 3) << "a half model has one side";
    const double lambda = plan.wave_length, cell = s.resolution.spacing;
    EXPECT_NEAR(lambda, 2 * pi * 1.879 * 1.879 / 9.81, 0.02 * lambda);
    EXPECT_NEAR(width(at(plan, 0, false)), lambda, cell);
    EXPECT_NEAR(width(at(plan, 0, true)), 1.5 * lambda, cell);
    EXPECT_NEAR(width(at(plan, 1, true)), std::max(0.5 * lambda, 8 * cell), cell);
    EXPECT_EQ(s.domain.box.min.y(), 0);
    EXPECT_EQ(forcing_zones(scene_of(ship("1.879 m/s", "[domain]\nsides = \"walls\"\n"))).zones.size(), 2);
    const Scene fast = scene_of(ship("4 m/s", "[domain]\nbelow = 4\n"));  // 0.64: the wave is longer than 10 m
    const ForcingZones capped = forcing_zones(fast);
    EXPECT_NEAR(width(at(capped, 0, true)), 1.5 * 1.5 * fast.hull->length, fast.resolution.spacing);
    EXPECT_NE(capped.why.find("1.5 hull lengths"), std::string::npos) << capped.why;
    const Scene slow = scene_of(ship("0.3 m/s"));
    const ForcingZone ahead = at(forcing_zones(slow), 0, false);
    EXPECT_NEAR(width(ahead), 8 * slow.resolution.spacing, 1e-9);
    EXPECT_NEAR(ahead.gamma, std::sqrt(2 * pi * 9.81 / width(ahead)), 1e-9);
    EXPECT_NE(to_text(slow, predict(slow)).find("8 of the largest spacings"), std::string::npos);
}

/// Of a flume with a wave maker of 1.2 s in water 0.4 m deep: waves of 1.94 m (linear theory).
std::string flume(const std::string& tank, const std::string& more = "[effects]\nforcing_zones = \"on\"\n") {
    return "[tank]\nmin = [-1.9, 0, -0.4]\nmax = [6.6, 0.01, 0.3]\n" + tank +
           "[domain]\ndimensions = 2\n[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.02\n[run]\nduration = 1\n"
           "[[body]]\nname = \"piston\"\nshape = \"box\"\nlength = 0.12\nbeam = 1\nheight = 0.5\nposition = [-0.06, "
           "0]\n"
           "draft = 0.3\nmotion = \"prescribed\"\nlaw = \"sinusoid\"\nalong = [1, 0, 0]\namplitude = 0.016\nperiod = "
           "1.2\n"
           "phase = \"90 deg\"\n" +
           more;
}

TEST(ForcingZones, OfAFlumeAreAWaveLongAndClearOfTheWaveMaker) {
    const ForcingZones plan = forcing_zones(scene_of(flume("")));
    ASSERT_EQ(plan.zones.size(), 2);
    const double k = 2 * pi / plan.wave_length, omega = 2 * pi / 1.2;
    EXPECT_NEAR(9.81 * k * std::tanh(0.4 * k), omega * omega, 1e-9);
    EXPECT_NEAR(plan.wave_length, 1.94, 0.005);
    EXPECT_EQ(plan.speed, 0);
    const ForcingZone &behind = at(plan, 0, false), &end = at(plan, 0, true);
    EXPECT_NEAR(width(end), plan.wave_length, 1e-12);
    EXPECT_EQ(end.end, 6.6);
    EXPECT_NEAR(behind.begin, -0.136, 1e-6);  // the piston's back where it swings to
    EXPECT_NEAR(end.gamma, 1.5 * omega / std::sqrt(std::tanh(0.4 * k)), 1e-9);
    EXPECT_EQ(forcing_zones(scene_of(flume("absorbing = \"x_max\"\n"))).zones.size(), 1);
    EXPECT_NEAR(width(forcing_zones(scene_of(flume("wave_length = 1\n"))).zones[1]), 1, 1e-12);
    EXPECT_TRUE(forcing_zones(scene_of(flume("", ""))).zones.empty());
}

TEST(ForcingZones, TheOlderNameIsReadAndSaid) {
    const Scene now = scene_of(flume("")), before = scene_of(flume("", "[effects]\ndamping_layers = \"on\"\n"));
    EXPECT_EQ(now.hash, before.hash);
    EXPECT_NE(to_text(before, predict(before)).find("damping_layers is an older name"), std::string::npos);
    EXPECT_EQ(to_text(now, predict(now)).find("damping_layers"), std::string::npos);
    EXPECT_NE(complaint(flume("", "[effects]\ndamping_layers = \"on\"\nforcing_zones = \"on\"\n")).find("given twice"),
              std::string::npos);
}

}  // namespace forcing_zones_test
}  // namespace tw::test
