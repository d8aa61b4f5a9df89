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

/// Harmonic n of a gauge's level over its last three periods, a in Re(a exp(-i n omega t)).
Complex harmonic(const RunRecord& r, const char* gauge, int n, const RegularWave& wave) {
    const Table& table = r.tables.at("height");
    const std::vector<double>& levels = table.find(gauge)->values;
    std::vector<double> t, x;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] > table.time.back() - 3 * wave.encounter_period())
            t.push_back(table.time[i]), x.push_back(levels[i]);
    return first_harmonic(t, x, n * wave.encounter_frequency());
}

// A wave 0.6 m long and 30 mm high in a stream of 2.1 times its speed, 4 cells of 7.5 mm in the height. Without the
// velocity upwards its first harmonic is 0.71 of that near the inlet, with the frequency in the water in place of that of
// encounter 0.03.
TEST_F(InletWaveInInterFoam, HasItsHeightAndItsPhaseAndKeepsTheLevel) {
    const Scene s = scene(R"(
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
[wave]
height = 0.03
length = 0.6
[fvm]
max_courant = 0.25
[[probe]]
name = "near"
height = [0.15, 0]
[[probe]]
name = "far"
height = [0.6, 0]
[sampling]
interval = 0.05
[run]
duration = 1.3
)");
    const RunRecord r = run_fvm(s, options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    for (const auto& [gauge, x] : {std::pair{"near", 0.15}, {"far", 0.6}}) {
        const Complex found = harmonic(r, gauge, 1, *s.wave) / (s.wave->sum.eta[0] * std::polar(1.0, s.wave->k() * x));
        std::printf("%s: first harmonic %.3f of that asked for, %.1f degrees late\n", gauge, std::abs(found),
                    std::arg(found) * 180 / std::numbers::pi);
        EXPECT_NEAR(std::abs(found), 1, 0.06) << gauge;
        EXPECT_NEAR(std::arg(found), 0, 0.12) << gauge;
    }
}

}  // namespace inlet_wave_test
}  // namespace tw
