// A wave that enters through interFoam's inlet with a stream that is faster than it, beside its theory at gauges.
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

#include "compare/metrics/regular_wave.h"
#include "foam_test.h"

namespace tw {
namespace inlet_wave_test {

using Complex = std::complex<double>;
using InletWaveInInterFoam = FoamTest;

/// First harmonic of a gauge's level over the last `time` seconds, a in Re(a exp(-i omega t)).
Complex harmonic(const RunRecord& r, const char* gauge, double omega, double time) {
    const Table& table = r.tables.at("height");
    const std::vector<double>& levels = table.find(gauge)->values;
    std::vector<double> t, x;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] > table.time.back() - time) t.push_back(table.time[i]), x.push_back(levels[i]);
    return first_harmonic(t, x, omega);
}

/// A stream of 2.1 m/s, 0.24 m deep, cells of 7.5 mm, gauges near the inlet and far from it.
std::string stream(const std::string& wave, double duration) {
    return R"(
[motion]
kind = "stream"
speed = 2.1
[domain]
x = [0, 0.9]
y = [0, 0.0075]
z = [-0.24, 0.075]
dimensions = 2
[water]
depth = 0.24
[resolution]
near_hull = 0.0075
[fvm]
max_courant = 0.25
[[probe]]
name = "near"
height = [0.15, 0]
[[probe]]
name = "far"
height = [0.6, 0]
[sampling]
interval = 0.01
[wave]
)" + wave +
           "[run]\nduration = " + std::to_string(duration) + "\n";
}
constexpr std::pair<const char*, double> gauges[] = {{"near", 0.15}, {"far", 0.6}};

// A wave 0.6 m long and 30 mm high in a stream of 2.1 times its speed, 4 cells of 7.5 mm in the height. Without the
// velocity upwards its first harmonic is 0.71 of that near the inlet, with the frequency in the water in place of that of
// encounter 0.03.
TEST_F(InletWaveInInterFoam, HasItsHeightAndItsPhaseAndKeepsTheLevel) {
    const Scene s = scene(stream("height = 0.03\nlength = 0.6\n", 1.3));
    const RunRecord r = run_fvm(s, options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    for (const auto& [gauge, x] : gauges) {
        const Complex found = harmonic(r, gauge, s.wave->encounter_frequency(), 3 * s.wave->encounter_period()) /
                              (s.wave->sum.eta[0] * std::polar(1.0, s.wave->k() * x));
        std::printf("%s: first harmonic %.3f of that asked for, %.1f degrees late\n", gauge, std::abs(found),
                    std::arg(found) * 180 / std::numbers::pi);
        EXPECT_NEAR(std::abs(found), 1, 0.06) << gauge;
        EXPECT_NEAR(std::arg(found), 0, 0.12) << gauge;
    }
}

// Two waves, 0.6 and 0.42 m long, 2.7 and 2.1 cells high: each as often as the stream brings its crests, over a beat.
TEST_F(InletWaveInInterFoam, OfTwoPartsHasEachAtItsFrequencyOfEncounter) {
    const Scene s =
        scene(stream("spectrum = \"bichromatic\"\nheight = 0.02\nperiod = 0.624\nsecond_height = 0.016\n"
                     "second_period = 0.52\n",
                     1.5));
    const RunRecord r = run_fvm(s, options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Sea& sea = *s.sea;
    for (const auto& [gauge, x] : gauges)
        for (int n = 0; n < 2; ++n) {
            const Complex found = harmonic(r, gauge, sea.met(n), sea.repeat_period) /
                                  (sea.waves.height[n] * std::polar(1.0, sea.waves.k[n] * x + sea.waves.phase[n]));
            std::printf("%s: wave met every %.3f s: %.3f of that asked for, %.1f degrees late\n", gauge,
                        2 * std::numbers::pi / sea.met(n), std::abs(found), std::arg(found) * 180 / std::numbers::pi);
            EXPECT_NEAR(std::abs(found), 1.05, 0.1) << gauge << n;  // found: 1.02 to 1.10, with ripples on the crests
            EXPECT_NEAR(std::arg(found), 0, 0.15) << gauge << n;
        }
}

}  // namespace inlet_wave_test
}  // namespace tw
