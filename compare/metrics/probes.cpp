#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "compare/metrics/forces.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/sound.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "statistics/error_of_mean.h"
#include "statistics/flow_through.h"
#include "statistics/time_bins.h"

namespace tw {

namespace {

/// The time that every source covers which has the probe [s].
struct Span {
    double from = -HUGE_VAL, to = HUGE_VAL;
};
Span common_span(const std::vector<RunRecord>& sources, const std::string& table, const std::string& column) {
    Span span;
    for (const RunRecord& r : sources) {
        if (!r.series(table, column) || r.tables.at(table).time.empty()) continue;
        const auto& time = r.tables.at(table).time;
        span.from = std::max(span.from, time.front()), span.to = std::min(span.to, time.back());
    }
    return span;
}

/// One probe's history in one record, within the span; empty where the record has no such probe.
struct History {
    std::vector<double> t, x;
    double sound = 0;                ///< what is shorter is sound [s]; 0: there is none
    std::vector<double> lasts = {};  ///< what of it lasts longer
};
History history_of(const RunRecord& record, const std::string& table, const std::string& column, const Span& span) {
    History h;
    const Column* c = record.series(table, column);
    if (!c) return h;
    const auto& time = record.tables.at(table).time;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= span.from && time[i] <= span.to) {
            h.t.push_back(time[i]);
            h.x.push_back(c->values[i]);
        }
    h.sound = table == "pressure" ? sound_time(record) : 0;
    h.lasts = lasting(h.t, h.x, h.sound);
    return h;
}

/// A number read off a history, without an interval of its own.
MeanValue reading(double value, const History& history, const char* why_not) {
    MeanValue m;
    m.known = std::isfinite(value);
    if (!m.known) {
        m.why_not = history.t.empty() ? not_given : why_not;
        return m;
    }
    m.value = value;
    m.half_width = 0;
    m.from = history.t.front(), m.to = history.t.back();
    return m;
}

double highest(std::span<const double>, std::span<const double> values) {
    double most = std::numeric_limits<double>::quiet_NaN();
    for (const double x : values)
        if (std::isfinite(x) && !(most >= x)) most = x;
    return most;
}

/// The time between samples of a record's table, of its middle pair in length; 0 where there are none [s].
double time_between_samples(const RunRecord& record, const std::string& table) {
    const auto found = record.tables.find(table);
    if (found == record.tables.end() || found->second.time.size() < 2) return 0;
    std::vector<double> steps(found->second.time.size());
    std::adjacent_difference(found->second.time.begin(), found->second.time.end(), steps.begin());
    const auto middle = steps.begin() + 1 + static_cast<std::ptrdiff_t>(steps.size() - 1) / 2;
    std::nth_element(steps.begin() + 1, middle, steps.end());
    return *middle;
}

/// Of all records: the probe's filter, or the longest time between samples of any of them. Heights are samples of the
/// frames in one method and of every step in the other: theirs is the scene's sampling interval in both.
double window_of(const Comparison& comparison, const std::string& table, const std::string& name) {
    double window = filter_of(comparison.sources, table, name);
    for (const RunRecord& r : comparison.sources)
        window =
            std::max(window, table == "height" ? number_of(r, "sampling_interval", 0) : time_between_samples(r, table));
    return window;
}

/// Root mean square of B - A over A's times that B covers, over A's range, in per cent; NaN when they share no time.
double rms_per_cent(const RunRecord& a, const RunRecord& b, const std::string& table, const std::string& column) {
    const Column *x = a.series(table, column), *y = b.series(table, column);
    if (!x || !y) return std::numeric_limits<double>::quiet_NaN();
    const auto &ta = a.tables.at(table).time, &tb = b.tables.at(table).time;
    double squares = 0, low = HUGE_VAL, high = -HUGE_VAL;
    int count = 0;
    for (std::size_t i = 0; i < ta.size(); ++i) {
        const double d = value_at(tb, y->values, ta[i]) - x->values[i];
        if (!std::isfinite(d)) continue;
        low = std::min(low, x->values[i]);
        high = std::max(high, x->values[i]);
        squares += d * d;
        ++count;
    }
    return count > 0 && high > low ? 100 * std::sqrt(squares / count) / (high - low)
                                   : std::numeric_limits<double>::quiet_NaN();
}

/// The part of a history between two times, as evenly spaced means.
std::vector<double> even_samples(std::span<const double> t, std::span<const double> x, double from, double to) {
    std::vector<double> times, values;
    for (std::size_t i = 0; i < t.size(); ++i)
        if (t[i] >= from && t[i] <= to && std::isfinite(x[i])) times.push_back(t[i]), values.push_back(x[i]);
    constexpr std::size_t most = 1000;
    return times.size() < 2 ? std::vector<double>{} : time_bins(times, values, std::min(times.size(), most));
}

/// Time mean over the scene's whole duration, from mean_from on, by trapezia. In a tank the scene determines the
/// history, and its mean has no statistical interval. A stream without a hull (weir, jump, channel) goes on: the time
/// is a sample of it, and what its waves and rollers do in other times is the interval of its mean. Waves that the
/// scene makes are no such scatter.
MeanValue mean_over_run(const RunRecord& record, const std::string& table, const std::string& column) {
    MeanValue m;
    m.why_not = not_given;
    const Column* c = record.series(table, column);
    if (!c) return m;
    const auto& t = record.tables.at(table).time;
    m.from = number_of(record, "mean_from", 0), m.to = number_of(record, "duration", 0);
    const double slack = t.size() < 2 ? 0 : 2 * (t.back() - t.front()) / double(t.size() - 1);
    if (t.size() < 2 || t.front() > m.from + slack || t.back() < m.to - slack) {
        m.why_not = fmt::format("the record does not cover {:g} to {:g} s", m.from, m.to);
        return m;
    }
    double sum = 0, width = 0;
    for (std::size_t i = 1; i < t.size(); ++i) {
        const double a = std::max(t[i - 1], m.from), b = std::min(t[i], m.to);
        if (!(b > a)) continue;
        sum += (b - a) * (value_at(t, c->values, a) + value_at(t, c->values, b)) / 2;
        width += b - a;
    }
    m.value = sum / width;
    m.known = std::isfinite(m.value);
    const bool goes_on = is_stream(record) && !(number_of(record, "wave_period", 0) > 0);
    m.half_width = goes_on ? half_width_of_mean(even_samples(t, c->values, m.from, m.to)) : 0;
    m.why_not = m.known ? "" : "the record has gaps";
    return m;
}

/// When water arrives at a gauge. The peak of which it is a share is that of what lasts: sound is no water.
Quantity arrival_at(const Comparison& c, const std::string& table, const std::string& name,
                    const std::vector<History>& histories, double window) {
    Quantity q = new_quantity(
        fmt::format("{}_arrival:{}", table, name), fmt::format("Arrival at {} ({})", name, table), "s",
        fmt::format(
            "first time at which the {} has risen by a tenth of the way from its first value to its largest mean "
            "over {:g} ms, sound left out",
            table, 1e3 * window));
    for (std::size_t s = 0; s < histories.size(); ++s) {
        const History& h = histories[s];
        const double lasting_peak = largest_window_mean(h.t, h.lasts, window),
                     peak = std::isfinite(lasting_peak) ? lasting_peak : largest_window_mean(h.t, h.x, window),
                     first = h.x.empty() ? peak : h.x.front();
        const double arrives =
            peak > first ? arrival_time(h.t, h.x, first + arrival_share * (peak - first)) : std::nan("");
        q.values.push_back(reading(arrives, h, "nothing arrives in the time that all records cover"));
        set_reading(q.values.back(), reading_of_arrival(h.t, h.x, first, peak, c.sources[s]), of_arrival);
    }
    beside(q);
    q.judged_in_grid_study = true;
    return q;
}

}  // namespace

void add_probes(Comparison& comparison, const CompareOptions& options) {
    for (const std::string table : {"pressure", "height"}) {
        std::set<std::pair<std::string, std::string>> probes;  // name, unit
        for (const RunRecord& r : comparison.sources)
            if (const auto found = r.tables.find(table); found != r.tables.end())
                for (const Column& c : found->second.columns) probes.emplace(c.name, c.unit);
        for (const auto& [name, unit] : probes) {
            const double filter = filter_of(comparison.sources, table, name),
                         window = window_of(comparison, table, name);
            const Span span = common_span(comparison.sources, table, name);
            std::vector<History> histories;
            for (const RunRecord& r : comparison.sources) histories.push_back(history_of(r, table, name, span));
            const bool tank =
                std::ranges::none_of(comparison.sources, [](const RunRecord& r) { return flow_through_time(r) > 0; });
            const auto add = [&](const std::string& kind, std::string label, const std::string& its_unit,
                                 std::string definition, bool in_grid_study, const char* why_not, auto&& value_of) {
                Quantity q = new_quantity(fmt::format("{}{}:{}", table, kind, name), std::move(label), its_unit,
                                          std::move(definition));
                for (const History& h : histories) q.values.push_back(reading(value_of(h.t, h.x), h, why_not));
                for (std::size_t s = 0; in_grid_study && s < histories.size(); ++s) {
                    const History& h = histories[s];
                    if (h.sound > 0) set_sound_aside(q, s, value_of(h.t, h.lasts), h.sound, comparison.names[s]);
                    if (table == "height")
                        set_reading(q.values[s], reading_of_height(comparison.sources[s]), of_height);
                }
                beside(q);
                q.judged_in_grid_study = in_grid_study && tank;
                comparison.quantities.push_back(std::move(q));
            };
            constexpr const char* nothing = "no value in the time that all records cover";
            add("", fmt::format("Peak {} at {}, raw", table, name), unit,
                "highest value in the time that all records cover: grows with the sampling rate and contains the sound "
                "of an impact, so it is shown and not judged",
                false, nothing, highest);
            comparison.quantities.back().remark = of_every_pair(comparison.names, [&](std::size_t a, std::size_t b) {
                const double rms = rms_per_cent(comparison.sources[a], comparison.sources[b], table, name);
                return std::isfinite(rms)
                           ? fmt::format("histories differ by {:.2g} % of the range (root mean square)", rms)
                           : std::string();
            });
            add("_peak", fmt::format("Peak {} at {}, mean over {:.3g} ms", table, name, 1e3 * window), unit,
                fmt::format(
                    "largest mean over {:.3g} ms ({:g} ms, or the time between samples where that is longer) in the "
                    "time that all records cover: the largest impulse over its time",
                    1e3 * window, 1e3 * filter),
                true, "its record is shorter than the window",
                [&](auto t, auto x) { return largest_window_mean(t, x, window); });
            add("_p99",
                fmt::format("{} at {} exceeded 1 % of the time", table == "height" ? "Height" : "Pressure", name), unit,
                "99th percentile over the time that all records cover", true, nothing,
                [](auto t, auto x) { return time_percentile(t, x, 0.99); });
            if (tank) comparison.quantities.push_back(arrival_at(comparison, table, name, histories, window));

            Quantity mean =
                new_quantity(fmt::format("{}_mean:{}", table, name), fmt::format("Mean {} at {}", table, name), unit,
                             "mean over the run; in a stream over its settled part");
            for (const RunRecord& r : comparison.sources)
                mean.values.push_back(flow_through_time(r) > 0 ? mean_of(r, table, name, options)
                                                               : mean_over_run(r, table, name));
            for (std::size_t s = 0; table == "height" && s < comparison.sources.size(); ++s)
                set_reading(mean.values[s], reading_of_height(comparison.sources[s]), of_height);
            beside(mean);
            mean.judged_in_grid_study = true;
            comparison.quantities.push_back(std::move(mean));
        }
    }
}

}  // namespace tw
