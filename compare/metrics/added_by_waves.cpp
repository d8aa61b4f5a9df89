#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "compare/metrics/forces.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/verdict/judge.h"
#include "record/hull_motion.h"
#include "record/wave_twin.h"

namespace tw {
namespace {

/// Mean of a column over the whole periods [its unit].
MeanValue mean_in_waves(const RunRecord& r, const std::string& table, const std::string& column,
                        const WavePeriods& periods) {
    const Column* c = r.series(table, column);
    if (!c) return unknown_value(not_given);
    std::vector<double> means;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const WaveSamples s = samples_between(r.tables.at(table).time, from, from + periods.period,
                                              [&](std::size_t i) { return c->values[i]; });
        if (static_cast<int>(s.t.size()) >= fewest_in_a_period)
            means.push_back(mean_level(s.t, s.x, 2 * std::numbers::pi / periods.period));
    }
    return mean_over(means, periods);
}

/// In waves less in calm water; the intervals are of two runs.
MeanValue difference(const MeanValue& in_waves, const MeanValue& calm) {
    if (!in_waves.known) return in_waves;
    if (!calm.known) return unknown_value("in the run without the wave: " + calm.why_not);
    MeanValue d = in_waves;
    d.value -= calm.value;
    d.half_width = std::hypot(in_waves.half_width, calm.half_width);
    d.second_opinion = std::numeric_limits<double>::quiet_NaN();
    return d;
}

}  // namespace

void add_added_by_waves(Comparison& comparison, const CompareOptions& options) {
    const WavePeriods periods = wave_periods(comparison);
    const auto is_calm = [](const RunRecord& r) { return r.tables.contains(std::string(calm_forces_table)); };
    if (periods.period <= 0 || std::ranges::none_of(comparison.sources, is_calm)) return;
    struct Part {
        const char *name, *label, *definition;
        std::string table, calm, column, unit;
        double fine;  ///< half width of a calm mean that is fine whatever the mean [unit]
    };
    const bool flat =
        std::ranges::any_of(comparison.sources, [](const RunRecord& r) { return number_of(r, "dimensions", 3) == 2; });
    const std::string forces(calm_forces_table), motion(calm_motion_table);
    const Part parts[] = {
        {"added_resistance", "Added resistance", "drag of the pressure, and of friction where it is solved", "forces",
         forces, "fx", flat ? "N/m" : "N", HUGE_VAL},
        {"added_trim", "Trim added by the waves", "trim, bow up", hull_motion_table, motion, "trim", "deg", HUGE_VAL},
        {"added_rise", "Rise added by the waves", "height of the centre of mass", hull_motion_table, motion, "z", "m",
         HUGE_VAL}};
    for (const Part& part : parts) {
        Quantity q = new_quantity(part.name, part.label, part.unit,
                                  fmt::format("{}: mean over {} whole periods in waves less the mean of the same run "
                                              "without the wave",
                                              part.definition, periods.count));
        bool any = false;
        double largest = 0;
        for (const RunRecord& r : comparison.sources) {
            const MeanValue in_waves = mean_in_waves(r, part.table, part.column, periods);
            if (in_waves.known) largest = std::max(largest, std::abs(in_waves.value));
            q.values.push_back(
                r.series(part.calm, part.column)
                    ? difference(in_waves, mean_of(r, part.calm, part.column, options, part.fine))
                    : unknown_value(text_of(r, std::string(no_wave_twin), "it was not run without the wave")));
            any |= r.series(part.calm, part.column) != nullptr;
        }
        if (!any) continue;
        beside(q);
        q.judged_in_ladder = true;
        q.scale = largest;
        comparison.quantities.push_back(std::move(q));
    }
}

}  // namespace tw
