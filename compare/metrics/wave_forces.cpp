#include <fmt/format.h>

#include <complex>
#include <numbers>
#include <optional>

#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/verdict/judge.h"

namespace tw {
namespace {

using std::numbers::pi;

/// Of one component in one record.
struct Force {
    MeanValue amplitude, phase, mean;
};

Force force_in(const Table& table, const std::string& column, const WavePeriods& periods) {
    std::vector<std::complex<double>> found;
    std::vector<double> amplitudes, means;
    const Column& force = *table.find(column);
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const WaveSamples s =
            samples_between(table.time, from, from + periods.period, [&](std::size_t i) { return force.values[i]; });
        if (static_cast<int>(s.t.size()) < fewest_in_a_period) continue;
        found.push_back(first_harmonic(s.t, s.x, 2 * pi / periods.period));
        amplitudes.push_back(std::abs(found.back()));
        means.push_back(mean_level(s.t, s.x, 2 * pi / periods.period));
    }
    std::complex<double> all = 0;
    for (const auto& one : found) all += one;
    std::vector<double> phases;  // round that of the mean
    for (const auto& one : found) phases.push_back(-180 / pi * (std::arg(all) + std::arg(one / all)));
    return {mean_over(amplitudes, periods), mean_over(phases, periods), mean_over(means, periods)};
}

}  // namespace

void add_wave_forces(Comparison& comparison, const WavePeriods& periods) {
    std::string unit;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables) {
            if (name.starts_with("body_")) return;  // what moves has responses
            if (name == "forces" && table.find("fx") && table.find("fz")) unit = table.find("fx")->unit;
        }
    if (unit.empty()) return;
    double largest = 0;
    std::vector<Quantity> found;
    for (const std::string axis : {"x", "z"}) {
        const std::string way = axis == "x" ? "along x" : "upward",
                          over = fmt::format("first harmonic of the force on all solids {}, mean over {} whole periods",
                                             way, periods.count);
        Quantity amplitude = new_quantity("wave_force_" + axis, "Wave force " + way, unit, "amplitude of the " + over),
                 phase = new_quantity("wave_force_phase_" + axis, "Phase of the wave force " + way, "deg",
                                      "lead over the theory's crest at x = 0; " + over),
                 mean = new_quantity("wave_drift_" + axis, "Mean wave force " + way, unit, "mean over whole periods");
        for (const RunRecord& r : comparison.sources) {
            const auto table = r.tables.find("forces");
            Force force{unknown_value(not_given), unknown_value(not_given), unknown_value(not_given)};
            if (table != r.tables.end() && table->second.find("f" + axis))
                force = force_in(table->second, "f" + axis, periods);
            if (force.amplitude.known) largest = std::max(largest, force.amplitude.value);
            amplitude.values.push_back(force.amplitude);
            phase.values.push_back(force.phase);
            mean.values.push_back(force.mean);
        }
        phase.scale = 180;
        found.push_back(std::move(amplitude));
        found.push_back(std::move(phase));
        if (axis == "x") found.push_back(std::move(mean));  // upward it holds the buoyancy
    }
    if (largest == 0) return;  // nothing stands there
    for (Quantity& q : found) {
        beside(q);
        q.judged_in_ladder = true;
        if (q.name == "wave_drift_x") q.scale = largest;
        comparison.quantities.push_back(std::move(q));
    }
}

}  // namespace tw
