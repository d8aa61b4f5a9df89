#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/metrics/wave_samples.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"

namespace tw {

inline constexpr int fewest_in_a_period = 14;  ///< samples, for a mean and three harmonics

/// The last whole periods within the time that all records cover [s].
struct WavePeriods {
    double from = 0, period = 0;
    int count = 0;
};
inline WavePeriods wave_periods(const Comparison& c) {
    WavePeriods p;
    double from = 0, to = HUGE_VAL;
    for (const RunRecord& r : c.sources) {
        for (const auto& [name, table] : r.tables) {
            if ((name != "height" && name != "forces" && !name.starts_with("body_")) || table.time.empty()) continue;
            from = std::max({from, table.time.front(), number_of(r, "mean_from", 0)});
            to = std::min(to, table.time.back());
        }
        p.period = std::max(p.period, number_of(r, "wave_period", 0));
    }
    if (!(p.period > 0) || !std::isfinite(to)) return p;
    p.count = std::max(0, static_cast<int>(std::floor((to - from) / p.period + 1e-6)));
    p.from = to - p.count * p.period;
    return p;
}

inline MeanValue mean_over(const std::vector<double>& values, const WavePeriods& periods) {
    if (periods.count < 3) return unknown_value("fewer than three whole periods were recorded");
    if (values.size() < 3)
        return unknown_value(fmt::format("fewer than {} samples a period were recorded; shorten [sampling] interval",
                                         fewest_in_a_period));
    const IndependentMean mean = mean_of_independent(values);
    return known_value(mean.value, mean.half_width, periods.from, periods.from + periods.count * periods.period);
}

}  // namespace tw
