#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "compare/align/time_bins.h"
#include "compare/metrics/forces.h"
#include "compare/metrics/quantity.h"
#include "compare/read/record_numbers.h"
#include "compare/verdict/judge.h"

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

/// Highest value within the span: one that only a longer record could have seen takes no part.
MeanValue peak(const RunRecord& record, const std::string& table, const std::string& column, const Span& span) {
    MeanValue m;
    m.why_not = not_given;
    const Column* c = record.series(table, column);
    if (!c) return m;
    const auto& time = record.tables.at(table).time;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= span.from && time[i] <= span.to && std::isfinite(c->values[i]) && !(m.value >= c->values[i])) {
            m.value = c->values[i];
            m.from = m.to = time[i];
        }
    m.known = std::isfinite(m.value);
    m.half_width = 0;
    m.why_not = m.known ? "" : "no value in the time that all records cover";
    return m;
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

/// Time mean over the scene's whole duration, from mean_from on, by trapezia: a history that the scene determines, so
/// without a statistical interval.
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
    m.half_width = 0;
    m.why_not = m.known ? "" : "the record has gaps";
    return m;
}

}  // namespace

void add_probes(Comparison& comparison, const CompareOptions& options) {
    for (const std::string table : {"pressure", "height"}) {
        std::set<std::pair<std::string, std::string>> probes;  // name, unit
        for (const RunRecord& r : comparison.sources)
            if (const auto found = r.tables.find(table); found != r.tables.end())
                for (const Column& c : found->second.columns) probes.emplace(c.name, c.unit);
        for (const auto& [name, unit] : probes) {
            Quantity q = new_quantity(
                fmt::format("{}:{}", table, name), fmt::format("Peak {} at {}", table, name), unit,
                "highest value in the time that all records cover; depends on that time and on the sampling");
            const Span span = common_span(comparison.sources, table, name);
            for (const RunRecord& r : comparison.sources) q.values.push_back(peak(r, table, name, span));
            beside(q);
            q.judged_in_ladder =
                std::ranges::none_of(comparison.sources, [](const RunRecord& r) { return flow_through_time(r) > 0; });
            if (q.values.size() >= 2) {
                const double rms = rms_per_cent(comparison.sources[0], comparison.sources[1], table, name);
                if (std::isfinite(rms))
                    q.remark = fmt::format("histories differ by {:.2g} % of the range (root mean square)", rms);
            }
            comparison.quantities.push_back(std::move(q));

            Quantity mean =
                new_quantity(fmt::format("{}_mean:{}", table, name), fmt::format("Mean {} at {}", table, name), unit,
                             "time mean over the run; in a stream of its settled part");
            for (const RunRecord& r : comparison.sources)
                mean.values.push_back(flow_through_time(r) > 0 ? mean_of(r, table, name, options)
                                                               : mean_over_run(r, table, name));
            beside(mean);
            mean.judged_in_ladder = true;
            comparison.quantities.push_back(std::move(mean));
        }
    }
}

}  // namespace tw
