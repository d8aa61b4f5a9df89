#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/metrics/quantity.h"
#include "record/hull_motion.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"
#include "statistics/whole_periods.h"

namespace tw {

// The samples of waves, and the time over which they are judged.

/// Of a regular wave, as it is met; of a sea that of its peak; 0: there are no waves [s].
inline double period_of_waves(const RunRecord& record) {
    return std::max(number_of(record, "wave_period", 0), number_of(record, "sea_peak_period", 0));
}

/// Known values of a series.
struct WaveSamples {
    std::vector<double> t, x;  ///< [s], [unit of the series]
};
/// The known values after `from`, up to `to` [s]; `of_row`: the value in a row.
template <class OfRow>
WaveSamples samples_between(const std::vector<double>& time, double from, double to, OfRow of_row) {
    WaveSamples s;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] > from && time[i] <= to * (1 + 1e-12) && std::isfinite(of_row(i)))
            s.t.push_back(time[i]), s.x.push_back(of_row(i));
    return s;
}
/// Of a height gauge; empty: the record has none of that name.
inline WaveSamples samples_of(const RunRecord& r, const std::string& gauge, double from, double to) {
    const Column* c = r.series("height", gauge);
    if (!c) return {};
    return samples_between(r.tables.at("height").time, from, to, [&](std::size_t i) { return c->values[i]; });
}

/// A highest or lowest place of a series.
struct TurningPoint {
    double t, x;  ///< [s]; above the level [unit of the series]
};
/// That of the parabola through a sample and its neighbours.
inline TurningPoint turning_point(std::span<const double> t, std::span<const double> x, std::size_t i, double level) {
    if (i == 0 || i + 1 == x.size()) return {t[i], x[i] - level};
    const double h1 = t[i] - t[i - 1], h2 = t[i + 1] - t[i], d1 = (x[i] - x[i - 1]) / h1, d2 = (x[i + 1] - x[i]) / h2,
                 bend = (d2 - d1) / (h1 + h2), slope = d1 + bend * h1,
                 at = bend == 0 ? 0 : std::clamp(-slope / (2 * bend), -h1, h2);
    return {t[i] + at, x[i] - level + slope * at + bend * at * at};
}

/// The time that the tables of all records cover which `counts`, from mean_from on [s]; without an end: there is none.
struct CommonTime {
    double from = 0, to = HUGE_VAL;  ///< [s]
};
template <class Counts>
CommonTime common_time(const Comparison& comparison, Counts counts) {
    CommonTime common;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables) {
            if (!counts(name) || table.time.empty()) continue;
            common.from = std::max({common.from, table.time.front(), number_of(r, "mean_from", 0)});
            common.to = std::min(common.to, table.time.back());
        }
    return common;
}

/// Names of the height gauges of all records.
inline std::set<std::string> gauges_of(const Comparison& comparison) {
    std::set<std::string> gauges;
    for (const RunRecord& r : comparison.sources)
        if (const auto found = r.tables.find("height"); found != r.tables.end())
            for (const Column& c : found->second.columns) gauges.insert(c.name);
    return gauges;
}

inline constexpr int fewest_in_a_period = 14;  ///< samples, for a mean and three harmonics

/// The last whole periods of a time, of the records the time that all cover.
struct WavePeriods {
    double from = 0, period = 0;  ///< [s]
    int count = 0;
};
inline WavePeriods last_periods(double from, double to, double period) {
    const int count = whole_periods(from, to, period);
    return {.from = to - count * period, .period = period, .count = count};
}
inline WavePeriods wave_periods(const Comparison& c) {
    WavePeriods p;
    const auto [from, to] = common_time(c, [](const std::string& table) {
        return table == "height" || table == "forces" || table == hull_motion_table || table.starts_with("body_");
    });
    for (const RunRecord& r : c.sources) p.period = std::max(p.period, number_of(r, "wave_period", 0));
    if (!(p.period > 0) || !std::isfinite(to)) return p;
    return last_periods(from, to, p.period);
}

/// The last whole periods of one series from a time on.
inline WavePeriods periods_of(const std::vector<double>& time, double from, double period) {
    if (time.empty() || !(period > 0)) return {.period = period};
    return last_periods(std::max(from, time.front()), time.back(), period);
}

/// Mean of one value a period; unknown where fewer than three whole periods tell it.
inline MeanValue mean_over(const std::vector<double>& values, const WavePeriods& periods) {
    if (periods.count < 3) return unknown_value("fewer than three whole periods were recorded");
    if (values.size() < 3)
        return unknown_value(fmt::format("fewer than {} samples a period were recorded; shorten [sampling] interval",
                                         fewest_in_a_period));
    const IndependentMean mean = mean_of_independent(values);
    return known_value(mean.value, mean.half_width, periods.from, periods.from + periods.count * periods.period);
}

}  // namespace tw
