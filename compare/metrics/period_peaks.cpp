#include "compare/metrics/period_peaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/numbers.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/sound.h"
#include "compare/verdict/judge.h"
#include "record/hull_motion.h"
#include "record/record_numbers.h"
#include "statistics/peak_statistics.h"

namespace tw {
namespace {

MeanValue value_of(const std::optional<PeakValue>& found, const WavePeriods& p) {
    if (!found) return unknown_value("too few peaks were recorded");
    return known_value(found->value, found->half_width(), p.from, p.from + p.count * p.period);
}

}  // namespace

PeakTime peak_time(const Comparison& c) {
    PeakTime p;
    double period = 0;
    for (const RunRecord& r : c.sources) {
        if (text_of(r, "sea") == "focused") return {};  // one event
        p.regular |= number_of(r, "wave_period", 0) > 0;
        period = std::max(period, period_of_waves(r));
    }
    const CommonTime time = common_time(c, [](const std::string& table) {
        return table == "height" || table == "pressure" || table == "forces" || table == hull_motion_table ||
               table.starts_with("body_");
    });
    constexpr double most = 1e5;  // more are no record of waves
    if (period > 0 && std::isfinite(time.to) && time.to - time.from < most * period)
        p.periods = last_periods(time.from, time.to, period);
    return p;
}

std::vector<double> peaks_of(const std::vector<double>& t, const std::vector<double>& x, double window,
                             const PeakTime& time) {
    struct Peak {
        double at, value;
    };
    std::vector<Peak> peaks;
    for (int n = 0; n < time.periods.count; ++n) {
        const double from = time.periods.from + n * time.periods.period, to = from + time.periods.period,
                     slack = 1e-9 * time.periods.period;  // a window about the ends is that of a peak there
        const auto first = std::ranges::lower_bound(t, from - window / 2 - slack),
                   last = std::ranges::upper_bound(t, to + window / 2 + slack);
        const auto at = static_cast<std::size_t>(first - t.begin()), count = static_cast<std::size_t>(last - first);
        const auto here = std::span(x).subspan(at, count);
        Peak peak{nan, nan};
        for (std::size_t i = 0; i < count; ++i)
            if (std::isfinite(here[i]) && !(peak.value >= here[i])) peak = {t[at + i], here[i]};
        if (window > 0) peak.value = largest_window_mean(std::span(t).subspan(at, count), here, window);
        if (std::isfinite(peak.value)) peaks.push_back(peak);
    }
    const double near = time.regular ? 0 : time.periods.period / 4;
    std::vector<double> values;
    for (std::size_t k = 0; k < peaks.size(); ++k) {
        const auto part_of = [&](std::size_t other) {
            const bool lower = other < k ? peaks[k].value <= peaks[other].value : peaks[k].value < peaks[other].value;
            return lower && std::abs(peaks[k].at - peaks[other].at) < near;
        };
        if ((k > 0 && part_of(k - 1)) || (k + 1 < peaks.size() && part_of(k + 1))) continue;
        values.push_back(peaks[k].value);
    }
    return values;
}

void add_peaks(Comparison& comparison, const PeakedThing& thing, const PeakTime& time) {
    struct OfSource {
        std::vector<double> peaks, lasting;
    };
    std::vector<OfSource> found;
    std::size_t most = 0;
    for (const PeakHistory& h : thing.histories) {
        OfSource one{peaks_of(h.t, h.x, thing.window, time), {}};
        if (!h.lasts.empty()) one.lasting = peaks_of(h.t, h.lasts, thing.window, time);
        most = std::max(most, one.peaks.size());
        found.push_back(std::move(one));
    }
    const WavePeriods& periods = time.periods;
    const auto add = [&](const std::string& name, const std::string& which, const std::string& definition,
                         auto&& evaluate) {
        Quantity q = new_quantity(name, fmt::format("{}{}", thing.label, which), thing.unit,
                                  fmt::format("{}, {}", thing.definition, definition));
        for (std::size_t s = 0; s < found.size(); ++s) {
            q.values.push_back(thing.histories[s].t.empty() ? unknown_value(not_given) : evaluate(found[s].peaks));
            if (!q.values[s].known || found[s].lasting.empty()) continue;
            if (const MeanValue lasts = evaluate(found[s].lasting); lasts.known)
                set_sound_aside(q, s, lasts.value, sound_time(comparison.sources[s]), comparison.names[s]);
        }
        beside(q);
        q.judged_in_grid_study = true;
        comparison.quantities.push_back(std::move(q));
    };
    add(thing.name_of_mean.empty() ? "peak_mean:" + thing.name : thing.name_of_mean, "",
        fmt::format("mean over {} whole {}periods of {:.4g} s", periods.count, time.regular ? "" : "peak ",
                    periods.period),
        [&](const std::vector<double>& peaks) { return mean_over(peaks, periods); });
    for (const int percentile : thing.percentiles) {
        const double p = percentile / 100.0;
        if (static_cast<int>(most) < fewest_peaks_for(p)) continue;
        const std::string words = percentile == 50 ? "median" : fmt::format("{}th percentile", percentile);
        add(fmt::format("peak_{}:{}", percentile == 50 ? "median" : fmt::format("p{}", percentile), thing.name),
            ", " + words,
            fmt::format("{} of {} peaks, ± to the farther end of its interval by order statistics", words, most),
            [&](const std::vector<double>& peaks) { return value_of(quantile_of_peaks(peaks, p), periods); });
    }
    if (static_cast<int>(most) >= fewest_peaks_for_third)
        add("peak_third:" + thing.name, ", highest third",
            fmt::format("mean of the highest third of {} peaks, its interval by bootstrap", most),
            [&](const std::vector<double>& peaks) { return value_of(highest_third(peaks), periods); });
    if (!std::isfinite(thing.threshold)) return;
    Quantity q = new_quantity("peak_events:" + thing.name, thing.label + ", events", "-",
                              fmt::format("{}: periods in which it is above {:.4g} {}, of {}; ± by Clopper and Pearson",
                                          thing.definition, thing.threshold, thing.unit, periods.count));
    for (std::size_t s = 0; s < found.size(); ++s) {
        if (thing.histories[s].t.empty() || periods.count < 1) {
            q.values.push_back(unknown_value(periods.count < 1 ? "no whole period was recorded" : not_given));
            continue;
        }
        const std::vector<double>& judged = found[s].lasting.empty() ? found[s].peaks : found[s].lasting;
        const auto events =
            static_cast<int>(std::ranges::count_if(judged, [&](double x) { return x > thing.threshold; }));
        q.values.push_back(value_of(count_of_events(events, periods.count), periods));
    }
    beside(q);
    q.judged_in_grid_study = true;
    comparison.quantities.push_back(std::move(q));
}

}  // namespace tw
