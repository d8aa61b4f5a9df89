// Sums of waves that a stream carries past the hull: frequencies as they are met, where they are made, what is refused.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "scene/box/forcing_zones.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/new_record.h"
#include "scene/summary/wave_text.h"
#include "scene_text.h"
#include "waves/dispersion.h"

namespace tw::test {
namespace sea_in_stream_test {

using std::numbers::pi;

std::string stream(const std::string& wave, double speed, const std::string& more = "") {
    return "[motion]\nkind = \"stream\"\nspeed = " + std::to_string(speed) +
           "\n[domain]\nx = [-2, 2]\ny = [0, 0.0125]\nz = [-0.4, 0.2]\ndimensions = 2\n[water]\ndepth = 0.4\n[wave]\n" +
           wave + "[resolution]\nnear_hull = 0.0125\n" + more;
}
const std::string
    jonswap = "spectrum = \"jonswap\"\nsignificant_height = 0.05\npeak_period = 1.5\n",
    moskowitz = "spectrum = \"pierson-moskowitz\"\nsignificant_height = 0.05\npeak_period = 1.5\n",
    two = "spectrum = \"bichromatic\"\nheight = 0.04\nperiod = 1.2\nsecond_height = 0.03\nsecond_period = 1\n",
    focused = "spectrum = \"focused\"\ncrest = 0.04\npeak_period = 1.5\n", follows = "direction = \"180 deg\"\n";

TEST(SeaInStream, IsMetAtWholeMultiplesOfOneFrequencyWithTheSpectrumsEnergy) {
    for (const std::string& wave : {jonswap, moskowitz})
        for (const bool head : {true, false}) {
            const double U = head ? 0.6 : 0.4, way = head ? 1 : -1;
            const Scene s = scene_of(stream(wave + (head ? "" : follows), U));
            ASSERT_TRUE(s.sea);
            const Sea& sea = *s.sea;
            EXPECT_NEAR(sea.significant_height, 0.05, 1e-12);
            for (int n = 0; n < sea.waves.count; ++n) {
                const double omega = wave_frequency(sea.waves.k[n], 9.81, 0.4);
                EXPECT_NEAR(sea.waves.omega[n], omega, 1e-9 * omega);
                EXPECT_NEAR(sea.met(n), omega + way * sea.waves.k[n] * U, 1e-9);
                const double multiple = sea.met(n) / (2 * pi) * sea.repeat_period;
                EXPECT_NEAR(multiple, std::round(multiple), 1e-6);
                EXPECT_GT(sea.met(n), n > 0 ? sea.met(n - 1) : 0);
            }
            // the same sea as one who drifts with the water sees: energy up to the peak as in a tank
            const auto up_to_peak = [](const Sea& of) {
                double below = 0;
                for (int n = 0; n < of.waves.count; ++n)
                    if (of.frequency(n) < 1 / 1.5) below += of.energy(n);
                return below / of.moment(0);
            };
            const Sea still =
                make_sea({.kind = sea.kind, .depth = 0.4, .height = 0.05, .peak_period = 1.5, .components = 96});
            EXPECT_NEAR(up_to_peak(sea), up_to_peak(still), 0.05);
            EXPECT_EQ(sea.waves.current, U);
        }
}

// To first order the surface moves with the water: d eta/dt + U d eta/dx = w. Velocities and surface come from different sums.
TEST(SeaInStream, HasASurfaceThatTheStreamCarries) {
    for (const std::string& wave : {jonswap, two, focused})
        for (const bool head : {true, false}) {
            const Scene s = scene_of(stream(wave + (head ? "" : follows), head ? 0.6 : 0.4));
            const WaveComponents& waves = s.sea->waves;
            const double U = s.motion.speed, h = 1e-5;
            for (const double t : {0.0, 3.7})
                for (double x = -1; x < 1.5; x += 0.7) {
                    const double along = (wave_surface(waves, x + h, t) - wave_surface(waves, x - h, t)) / (2 * h),
                                 rises = (wave_surface(waves, x, t + h) - wave_surface(waves, x, t - h)) / (2 * h);
                    double u, w;
                    wave_velocity(wave_moment(waves, t), x, 0, u, w);
                    EXPECT_NEAR(rises + U * along, w, 1e-6) << wave << x;
                }
        }
}

TEST(SeaInStream, FocusesWhereAndWhenItSays) {
    for (const bool head : {true, false}) {
        const Scene s = scene_of(
            stream(focused + (head ? "" : follows), head ? 0.6 : 0.4, "[[probe]]\nname = \"g\"\nheight = [0, 0]\n"));
        const Sea& sea = *s.sea;
        EXPECT_NEAR(sea.focus_place, 0, 1e-9);
        EXPECT_NEAR(wave_surface(sea.waves, sea.focus_place, sea.focus_time), 0.04, 1e-9);
        const WaveScales wave = wave_scales(s);
        EXPECT_GE(sea.focus_time, (2 + 1.5 * wave.longest) / wave.slowest);
        EXPECT_NEAR(s.sampling.mean_from, sea.focus_time - 2 * wave.period, 1e-9);
        const RunRecord record = new_record(s, "sph");
        EXPECT_NEAR(record.numbers.at("sea_crest_first_g"), 0.04, 1e-6);
        EXPECT_NEAR(record.numbers.at("sea_crest_time_first_g"), sea.focus_time, 1e-3);
    }
}

TEST(SeaInStream, IsMadeWhereItsEnergyComesFrom) {
    for (const bool head : {true, false}) {
        const Scene s = scene_of(stream(jonswap + (head ? "" : follows), head ? 0.6 : 0.4));
        const WaveScales wave = wave_scales(s);
        const ForcingZones plan = forcing_zones(s);
        ASSERT_EQ(plan.zones.size(), 2);
        EXPECT_EQ(plan.zones[0].makes_wave, head);
        EXPECT_EQ(plan.zones[1].makes_wave, !head);
        const Sea& sea = *s.sea;
        const int low = sea.component_at(waves_that_count), high = sea.component_at(1 - waves_that_count);
        const auto group = [&](int n) {
            return group_speed_ratio(sea.waves.k[n] * 0.4) * sea.waves.omega[n] / sea.waves.k[n];
        };
        EXPECT_NEAR(wave.slowest, head ? group(high) + 0.6 : group(high) - 0.4, 1e-9);
        const double rate = head ? sea.met(low) : sea.waves.omega[low] * (group(low) - 0.4) / group(low),
                     gamma = 1.5 * rate / std::sqrt(std::tanh(sea.waves.k[low] * 0.4));
        for (const ForcingZone& zone : plan.zones) {
            EXPECT_GE(std::abs(zone.end - zone.begin), (zone.makes_wave ? 1.5 : 1) * wave.longest - 1e-9);
            EXPECT_NEAR(zone.gamma, (zone.makes_wave ? 1.5 : 1) * gamma, 0.03 * gamma);
        }
        EXPECT_NEAR(s.run.duration - s.sampling.mean_from, sea.repeat_period, 1e-9);
        EXPECT_NE(wave_text(s).find(head ? "head waves" : "following waves"), std::string::npos) << wave_text(s);
    }
}

const std::string off = "[effects]\nforcing_zones = \"off\"\n", on = "[effects]\nforcing_zones = \"on\"\n";

TEST(SeaInStream, EntersWithAStreamThatIsFasterThanTheLongestThatCounts) {
    for (const std::string& wave : {jonswap, moskowitz, two, focused}) {
        const Scene s = scene_of(stream(wave, 2.5));  // above the critical speed no wave stands
        const auto enters = inlet_wave(s);
        ASSERT_TRUE(enters) << wave;
        const Sea& sea = *s.sea;
        const int low = sea.component_at(waves_that_count);
        EXPECT_EQ(enters->begin, s.motion.ramp);
        EXPECT_NEAR(enters->ramp, 2 * pi / sea.met(low), 1e-12);  // no wave that counts grows faster
        EXPECT_TRUE(forcing_zones(s).zones.empty());
        EXPECT_EQ(s.domain.box.min.x(), s.domain.as_asked.min.x());
        if (sea.kind != Sea::Kind::focused) {
            EXPECT_GE(s.sampling.mean_from, enters->begin + enters->ramp + 4 / wave_scales(s).slowest);
            EXPECT_NEAR(s.run.duration - s.sampling.mean_from, wave_scales(s).measured, 1e-9);
        }
        EXPECT_NE(wave_text(s).find("through the inlet"), std::string::npos) << wave_text(s);
        EXPECT_EQ(wave_text(s).find("between the zones"), std::string::npos) << wave_text(s);
    }
    for (const Scene& s : {scene_of(stream(two, 1.6)), scene_of(stream(two, 1.6, on)), scene_of(stream(two, 0.6))})
        EXPECT_FALSE(inlet_wave(s));
}

// Of a stream between the speeds of the longest that counts and of the longest of all.
TEST(SeaInStream, EntersWithItsLongestWavesFasterThanTheStream) {
    const std::string short_one = "spectrum = \"jonswap\"\nsignificant_height = 0.05\npeak_period = 0.9\n";
    const Scene slow = scene_of(stream(short_one, 0.6));
    const Sea& sea = *slow.sea;
    const int low = sea.component_at(waves_that_count);
    const double longest = sea.waves.omega[0] / sea.waves.k[0], counts = sea.waves.omega[low] / sea.waves.k[low];
    EXPECT_GT(longest, 1.05 * counts);
    EXPECT_TRUE(inlet_wave(scene_of(stream(short_one, 1.03 * counts, off))));
    // below it zones would have to make them, which above 1.5 times the speed of the shortest they do not
    for (const auto& [speed, part] :
         {std::pair{0.95 * counts, "the speed of the longest waves that count (5 % of the energy is in longer ones)"},
          {0.7 * counts,
           "head waves enter with a stream of at least the speed of the longest that count, with 5 % of "
           "the energy in longer ones"}}) {
        const std::string said = complaint(stream(short_one, speed, off));
        EXPECT_NE(said.find(part), std::string::npos) << said;
    }
}

TEST(SeaInStream, FocusesAsSoonAsItHasGrownAndComeFromTheInlet) {
    const Scene s = scene_of(stream(focused, 2.5));
    const WaveScales wave = wave_scales(s);
    const double least = s.motion.ramp + time_to_grow_at_inlet(s) + 2 / wave.slowest;  // 2 m from the inlet
    EXPECT_NEAR(s.sea->focus_time, least + 4 * wave.period, 1e-9);
    EXPECT_NEAR(wave_surface(s.sea->waves, 0, s.sea->focus_time), 0.04, 1e-9);
    const std::string said = complaint(stream(focused + "focus_time = " + std::to_string(0.9 * least) + "\n", 2.5));
    EXPECT_NE(said.find("have grown at the inlet"), std::string::npos) << said;
}

TEST(SeaInStream, TellsTheRecordWhatGaugesMeet) {
    const Scene s = scene_of(stream(two + follows, 0.4));
    const RunRecord record = new_record(s, "sph");
    std::istringstream text(record.attributes.at("sea_components"));
    double f[2], k[2], a, phase;
    for (int n = 0; n < 2; ++n) text >> f[n] >> k[n] >> a >> phase;
    for (int n = 0; n < 2; ++n) EXPECT_NEAR(2 * pi * f[n], wave_frequency(k[n], 9.81, 0.4) - 0.4 * k[n], 1e-6);
    EXPECT_NEAR(record.numbers.at("sea_repeat_period"), 1 / (f[1] - f[0]), 1e-6);
    EXPECT_NEAR(record.numbers.at("sea_peak_period"), 1 / f[0], 1e-6);
    EXPECT_EQ(record.numbers.at("wave_direction"), -1);
}

TEST(SeaInStream, RefusesWhatStandsStillOrIsTooFast) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_NE(said.find("scene.toml:"), std::string::npos) << said;
    };
    for (const std::string& wave : {jonswap, two, focused})
        refused(stream(wave + follows, 0.8), "hardly passes the hull or never comes");
    refused(stream(jonswap, 2.5, on), "the shortest that counts");
    refused(stream(jonswap, 0.1), "under its troughs");
    refused(stream(two + follows, 0.1), "under its crests");
    refused(with(stream(jonswap, 0.6), "0.2]", "0.04]"), "expected a higher box");
    refused(stream(focused + "focus_place = 2.5\n", 0.6), "between the");
    refused(stream(focused + "focus_time = 1\n", 0.6), "in a stream they begin in that zone");
}

}  // namespace sea_in_stream_test
}  // namespace tw::test
