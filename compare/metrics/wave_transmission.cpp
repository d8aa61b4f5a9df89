#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/metrics/wave_analysis.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

/// Amplitude of the part of the first harmonic that runs with the wave [m]; of one gauge that of all; NaN: not known.
double running_on(const GaugeHarmonics& h, double k) {
    if (h.x.empty()) return NAN;
    if (h.x.size() == 1) return std::abs(h.amplitude.front());
    const WaveParts parts = split_waves(h.x, h.amplitude, k);
    return parts.apart ? std::abs(parts.incident) : NAN;
}

MeanValue transmission_in(const RunRecord& r, const GaugeSides& sides, const WavePeriods& periods) {
    const double omega = 2 * std::numbers::pi / periods.period,
                 k = 2 * std::numbers::pi / number_of(r, "wave_length", NAN);
    std::vector<double> shares;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period, to = from + periods.period;
        const GaugeHarmonics before = harmonics_at(r, sides.before, from, to, omega, fewest_in_a_period),
                             behind = harmonics_at(r, sides.behind, from, to, omega, fewest_in_a_period);
        if (before.x.size() < 2) continue;
        const double share = 100 * running_on(behind, k) / running_on(before, k);
        if (std::isfinite(share)) shares.push_back(share);
    }
    if (shares.empty() && periods.count > 0)
        return unknown_value(
            "it takes two gauges before obstacle or body, no half wave length apart, and one behind it");
    return mean_over(shares, periods);
}

}  // namespace

void add_wave_transmission(Comparison& comparison, const GaugeSides& sides, const WavePeriods& periods) {
    if (sides.behind.empty()) return;
    Quantity q =
        new_quantity("wave_transmission", "Transmission of the wave", "%",
                     sides.behind.size() > 1 ? "first harmonic that runs on behind obstacle or body over that "
                                               "before it, each by least squares over its gauges"
                                             : "first harmonic at the gauge behind obstacle or body, with what "
                                               "comes back there, over that which runs towards it");
    for (const RunRecord& r : comparison.sources) q.values.push_back(transmission_in(r, sides, periods));
    beside(q);
    q.judged_in_grid_study = true;
    comparison.quantities.push_back(std::move(q));
}

}  // namespace tw
