#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/metrics/forces.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/verdict/judge.h"
#include "record/hull_motion.h"
#include "record/wave_twin.h"
#include "statistics/settled_mean.h"

namespace tw {
namespace {

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

/// Settled mean of a column of the calm twin, whatever its error.
MeanValue calm_mean(const RunRecord& r, const std::string& table, const std::string& column,
                    const CompareOptions& options) {
    return settled_mean(r.tables.at(table).time, r.series(table, column)->values, settled_rules(r, options, HUGE_VAL));
}

}  // namespace

void add_added_by_waves(Comparison& comparison, const CompareOptions& options) {
    const WavePeriods periods = wave_periods(comparison);
    const auto is_calm = [](const RunRecord& r) { return r.tables.contains(std::string(calm_forces_table)); };
    if (periods.period <= 0 || std::ranges::none_of(comparison.sources, is_calm)) return;
    struct Part {
        const char *name, *label, *definition;
        std::string table, calm, column, unit;
    };
    const bool flat =
        std::ranges::any_of(comparison.sources, [](const RunRecord& r) { return number_of(r, "dimensions", 3) == 2; });
    const std::string forces(calm_forces_table), motion(calm_motion_table);
    const Part parts[] = {
        {"added_resistance", "Added resistance", "drag of the pressure, and of friction where it is solved", "forces",
         forces, "fx", flat ? "N/m" : "N"},
        {"added_trim", "Trim added by the waves", "trim, bow up", hull_motion_table, motion, "trim", "deg"},
        {"added_rise", "Rise added by the waves", "height of the centre of mass", hull_motion_table, motion, "z", "m"}};
    for (const Part& part : parts) {
        Quantity q = new_quantity(part.name, part.label, part.unit,
                                  fmt::format("{}: mean over {} whole periods in waves less the mean of the same run "
                                              "without the wave",
                                              part.definition, periods.count));
        bool any = false;
        double largest = 0;
        for (const RunRecord& r : comparison.sources) {
            const MeanValue in_waves = mean_in_periods(r, part.table, part.column, periods);
            if (in_waves.known) largest = std::max(largest, std::abs(in_waves.value));
            q.values.push_back(
                r.series(part.calm, part.column)
                    ? difference(in_waves, calm_mean(r, part.calm, part.column, options))
                    : unknown_value(text_of(r, std::string(no_wave_twin), "it was not run without the wave")));
            any |= r.series(part.calm, part.column) != nullptr;
        }
        if (!any) continue;
        beside(q);
        q.judged_in_grid_study = true;
        q.scale = largest;
        comparison.quantities.push_back(std::move(q));
    }
}

}  // namespace tw
