// Waves that a stream carries, made by zones of the particle method, beside linear theory at gauges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "base/atomic_file.h"
#include "compare/metrics/regular_wave.h"
#include "scene/box/forcing_zones.h"
#include "sph_solver/run_sph.h"

namespace tw {
namespace wave_in_stream_test {

using std::numbers::pi;
using Complex = std::complex<double>;

/// An empty box 0.6 m long of 0.3 m of water, gauges in it, particles of 12.5 mm.
std::string text(double speed, double duration, const std::string& wave) {
    return "[motion]\nkind = \"stream\"\nspeed = " + std::to_string(speed) +
           "\n[domain]\nx = [-0.3, 0.3]\ny = [0, 0.0125]\nz = [-0.3, 0.1]\ndimensions = 2\n[water]\ndepth = 0.3\n"
           "[resolution]\nnear_hull = 0.0125\n[wave]\n" +
           wave +
           "[[probe]]\nname = \"a\"\nheight = [-0.2, 0]\n[[probe]]\nname = \"b\"\nheight = [0, 0]\n[[probe]]\nname = "
           "\"c\"\nheight = [0.15, 0]\n[sampling]\ninterval = 0.02\n[run]\nduration = " +
           std::to_string(duration) + "\n";
}

struct Ran {
    Scene scene;
    RunRecord record;
};
Ran run(const std::string& name, const std::string& scene) {
    const auto folder = std::filesystem::temp_directory_path() / "twinwake_wave_in_stream" / name;
    std::filesystem::create_directories(folder);
    write_text_atomically(folder / "scene.toml", scene);
    RunOptions options;
    options.folder = folder / "run";
    options.overwrite = true;
    options.threads = 1;
    const Scene read = read_scene(folder / "scene.toml");
    return {read, run_sph(read, options)};
}

/// Of a gauge's level over the last `time` seconds, a in Re(a exp(-i omega t)).
Complex amplitude(const RunRecord& r, const char* gauge, double omega, double time) {
    const Table& table = r.tables.at("height");
    const std::vector<double>& levels = table.find(gauge)->values;
    std::vector<double> t, x;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] > table.time.back() - time) t.push_back(table.time[i]), x.push_back(levels[i]);
    return first_harmonic(t, x, omega);
}
const std::string no_zones = "[effects]\nforcing_zones = \"off\"\n";
constexpr std::pair<const char*, double> gauges[] = {{"a", -0.2}, {"b", 0}, {"c", 0.15}};

// At a speed of half of its energy's a following wave comes from behind, crest by crest against the stream, and is met less
// often than in still water.
TEST(WaveInStream, ThatFollowsComesFromBehindWithItsHeightPeriodAndPhase) {
    const auto [scene, record] =
        run("follows", text(0.3, 13, "height = 0.05\nlength = 0.8\ndirection = \"180 deg\"\n"));
    ASSERT_EQ(record.state, "finished") << record.reason;
    const RegularWave& wave = *scene.wave;
    const double omega = wave.encounter_frequency(), k = wave.k();
    EXPECT_LT(omega, 0.8 * 2 * pi / wave.period_in_water());
    for (const auto& [gauge, x] : gauges) {
        const Complex found = amplitude(record, gauge, omega, 4 * wave.encounter_period()) /
                              (wave.sum.eta[0] * std::polar(1.0, -k * x)),
                      other = amplitude(record, gauge, omega + 2 * 0.3 * k, 4 * wave.encounter_period());
        std::printf("%s: height %.3f of that asked for, phase %.1f degrees, at a head wave's frequency %.3f\n", gauge,
                    std::abs(found), std::arg(found) * 180 / pi, std::abs(other) / wave.sum.eta[0]);
        // four sizes in the height lose 4 % in a wave length of this slow energy; lower waves are slower, and arrive later
        EXPECT_NEAR(std::abs(found), 0.95, 0.1) << gauge;
        EXPECT_NEAR(std::arg(found), 0.2, 0.25) << gauge;
        EXPECT_LT(std::abs(other), 0.2 * wave.sum.eta[0]);  // or any oscillation would do
    }
}

// Two waves on one another ahead of the hull: each is met as often as the stream brings its crests.
TEST(WaveInStream, OfTwoPartsHasEachAtItsFrequencyOfEncounter) {
    const auto [scene, record] = run(
        "two", text(0.4, 9,
                    "spectrum = \"bichromatic\"\nheight = 0.03\nperiod = 0.7\nsecond_height = 0.025\nsecond_period = "
                    "0.55\n"));
    ASSERT_EQ(record.state, "finished") << record.reason;
    const Sea& sea = *scene.sea;
    for (const auto& [gauge, x] : gauges)
        for (int n = 0; n < 2; ++n) {
            const Complex found = amplitude(record, gauge, sea.met(n), 3 * sea.repeat_period) /
                                  (sea.waves.height[n] * std::polar(1.0, sea.waves.k[n] * x + sea.waves.phase[n]));
            std::printf("%s: wave of %.2f s, met every %.3f s: amplitude %.3f of that asked for, phase %.1f degrees\n",
                        gauge, 1 / sea.frequency(n), 2 * pi / sea.met(n), std::abs(found), std::arg(found) * 180 / pi);
            // found: 0.97 to 0.99 and 0.80 to 0.88; the second is two sizes high and loses a fifth
            EXPECT_NEAR(std::abs(found), n == 0 ? 0.98 : 0.84, 0.1) << gauge << n;
            EXPECT_NEAR(std::arg(found), 0, 0.35) << gauge << n;
        }
    for (const auto& [gauge, x] : gauges)  // where it were met in water at rest
        EXPECT_LT(std::abs(amplitude(record, gauge, sea.waves.omega[0], 3 * sea.repeat_period)),
                  0.3 * sea.waves.height[0]);
}

// The stream is faster than the wave, which enters with it without any zone.
TEST(WaveInStream, ThatEntersWithItHasItsHeightPeriodAndPhase) {
    const auto [scene, record] = run("enters", text(2, 4, "height = 0.05\nlength = 0.8\n") + no_zones);
    ASSERT_EQ(record.state, "finished") << record.reason;
    const RegularWave& wave = *scene.wave;
    EXPECT_GT(2, 1.5 * wave.speed_in_water);
    const double omega = wave.encounter_frequency();
    for (const auto& [gauge, x] : gauges) {
        const Complex found = amplitude(record, gauge, omega, 6 * wave.encounter_period()) /
                              (wave.sum.eta[0] * std::polar(1.0, wave.k() * x));
        std::printf("%s: height %.3f of that asked for, phase %.1f degrees\n", gauge, std::abs(found),
                    std::arg(found) * 180 / pi);
        EXPECT_NEAR(std::abs(found), 1, 0.03) << gauge;
        EXPECT_NEAR(std::arg(found), 0, 0.1) << gauge;
    }
}

// As above, of two waves: each has its height and phase by the frequency at which the stream brings its crests.
TEST(WaveInStream, OfTwoPartsThatEnterWithItHasEachAtItsFrequencyOfEncounter) {
    const auto [scene, record] =
        run("two_enter", text(2.5, 3.2,
                              "spectrum = \"bichromatic\"\nheight = 0.03\nperiod = 0.8\nsecond_height = "
                              "0.025\nsecond_period = 0.65\n") +
                             no_zones);
    ASSERT_EQ(record.state, "finished") << record.reason;
    const Sea& sea = *scene.sea;
    EXPECT_TRUE(forcing_zones(scene).zones.empty());
    for (const auto& [gauge, x] : gauges)
        for (int n = 0; n < 2; ++n) {
            const Complex found = amplitude(record, gauge, sea.met(n), 3 * sea.repeat_period) /
                                  (sea.waves.height[n] * std::polar(1.0, sea.waves.k[n] * x + sea.waves.phase[n]));
            std::printf("%s: wave of %.2f s, met every %.3f s: amplitude %.3f of that asked for, phase %.1f degrees\n",
                        gauge, 1 / sea.frequency(n), 2 * pi / sea.met(n), std::abs(found), std::arg(found) * 180 / pi);
            EXPECT_NEAR(std::abs(found), 0.98, 0.05) << gauge << n;
            EXPECT_NEAR(std::arg(found), 0, 0.12) << gauge << n;
        }
}

TEST(WaveInStream, OfAGroupThatEntersWithItFocusesAtItsPlaceAndTime) {
    const auto [scene, record] =
        run("focus_enters", text(2.5, 2.4,
                                 "spectrum = \"focused\"\ncrest = 0.02\npeak_period = 0.8\nfocus_place = 0\n"
                                 "focus_time = 1.6\n") +
                                no_zones);
    ASSERT_EQ(record.state, "finished") << record.reason;
    const Table& table = record.tables.at("height");
    const std::vector<double>& level = table.find("b")->values;  // at x = 0
    const auto top = static_cast<std::size_t>(std::ranges::max_element(level) - level.begin());
    const Crest linear = highest_crest(*scene.sea, 0, 0.8, 2.4, false),
                second = highest_crest(*scene.sea, 0, 0.8, 2.4, true);
    std::printf("crest %.1f mm at %.3f s; by first and second order %.1f and %.1f mm at %.3f s\n", 1e3 * level[top],
                table.time[top], 1e3 * linear.height, 1e3 * second.height, linear.time);
    EXPECT_GT(level[top], 0.93 * linear.height);
    EXPECT_LT(level[top], 1.12 * second.height);  // without bound waves the level is k a^2/2 higher under the group
    EXPECT_NEAR(table.time[top], linear.time, 0.021);  // a sample
    for (std::size_t i = 0; i < level.size(); ++i)     // before and after it no crest is half as high
        if (std::abs(table.time[i] - linear.time) > 0.6) { EXPECT_LT(level[i], 0.6 * linear.height) << table.time[i]; }
}

}  // namespace wave_in_stream_test
}  // namespace tw
