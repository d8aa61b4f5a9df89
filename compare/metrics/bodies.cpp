#include "compare/metrics/bodies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "base/numbers.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/sound.h"
#include "compare/metrics/wave_samples.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/record_numbers.h"
#include "statistics/time_bins.h"

namespace tw {
namespace {

/// One body in one record, up to the end of the time that all records cover.
struct BodyHistory {
    const Table* table = nullptr;
    double end = 0;  ///< [s]

    bool has(const char* column) const { return table && table->find(column); }
    const std::vector<double>& of(const char* column) const { return table->find(column)->values; }
    double at_end(const char* column) const { return has(column) ? value_at(table->time, of(column), end) : nan; }
    std::size_t rows() const {
        return static_cast<std::size_t>(std::ranges::upper_bound(table->time, end) - table->time.begin());
    }
    std::span<const double> times() const { return {table->time.data(), rows()}; }
    std::span<const double> values(const char* column) const { return {of(column).data(), rows()}; }
};

/// The first value: bodies are released where all records have them, and their first rows are a step later.
double start_of(const BodyHistory& h, const char* column) { return h.has(column) ? h.of(column).front() : nan; }

double impulse_of(const BodyHistory& h) {
    if (!h.has("fz")) return nan;
    const auto f = h.values("fz");
    const auto known = std::ranges::find_if(f, [](double value) { return std::isfinite(value); });
    const auto first = static_cast<std::size_t>(known - f.begin());  // a false start has no force
    return time_integral(h.times().subspan(first), f.subspan(first));
}

double peak_of(const BodyHistory& h, double filter) {
    return h.has("fz") ? largest_window_mean(h.times(), h.values("fz"), filter) : nan;
}

double arrival_of(const BodyHistory& h, double filter) {
    const double peak = peak_of(h, filter);
    if (!(peak > 0)) return nan;
    return arrival_time(h.times(), h.values("fz"), arrival_share * peak);
}

double turn_of(const BodyHistory& h) {
    const double q0 = h.at_end("q0");
    return std::isfinite(q0) ? 2 * std::acos(std::clamp(std::abs(q0), 0.0, 1.0)) * 180 / std::numbers::pi : nan;
}

/// Mean square of b(t + lag) - a(t) over the times of `a` at which both are known; NaN with fewer than half of them.
double mean_square(std::span<const double> ta, std::span<const double> a, std::span<const double> tb,
                   std::span<const double> b, double lag) {
    double sum = 0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < ta.size(); ++i) {
        const double d = value_at(tb, b, ta[i] + lag) - a[i];
        if (!std::isfinite(d)) continue;
        sum += d * d;
        ++known;
    }
    return 2 * known >= ta.size() && known > 0 ? sum / static_cast<double>(known) : nan;
}

std::string rms_of_depths(const BodyHistory& a, const BodyHistory& b) {
    if (!a.has("z") || !b.has("z")) return {};  // as where there is no such body
    const auto z = a.values("z");
    const auto [low, high] = std::ranges::minmax(z);
    const double squares = mean_square(a.times(), z, b.times(), b.values("z"), 0);
    if (!(high > low) || !std::isfinite(squares)) return {};
    return fmt::format("depths differ by {:.2g} % of their range (root mean square)",
                       100 * std::sqrt(squares) / (high - low));
}

bool is_gauge(const Column& c) {
    return c.unit == "-" && c.name != "q0" && c.name != "qx" && c.name != "qy" && c.name != "qz";
}

MeanValue peak_of(const RunRecord& r, const std::string& table, const std::string& gauge, double end) {
    MeanValue m;
    const Column* c = r.series(table, gauge);
    m.why_not = not_given;
    if (!c) return m;
    const std::vector<double>& time = r.tables.at(table).time;
    for (std::size_t k = 0; k < time.size() && time[k] <= end * (1 + 1e-9); ++k)
        if (std::isfinite(c->values[k]) && !(std::abs(c->values[k]) <= std::abs(m.value))) m.value = c->values[k];
    m.known = std::isfinite(m.value);
    if (!m.known) return m;
    m.why_not.clear();
    m.half_width = 0, m.from = time.front(), m.to = end;
    return m;
}

/// "SPH: elastic; interFoam: rigid", or nothing where all are alike.
std::string unlike_structures(const Comparison& c) {
    std::set<std::string> kinds;
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < c.sources.size(); ++i) {
        const std::string kind = text_of(c.sources[i], "structure");
        if (kind.empty()) continue;
        kinds.insert(kind);
        parts.push_back(fmt::format("{}: {}", method_label(c.names[i]), kind));
    }
    return kinds.size() < 2 ? std::string() : fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

double lag_of(std::span<const double> ta, std::span<const double> a, std::span<const double> tb,
              std::span<const double> b) {
    if (ta.empty() || tb.empty()) return nan;
    const double shared = std::min(ta.back(), tb.back()) - std::max(ta.front(), tb.front());
    double best = nan, least = HUGE_VAL;
    constexpr int steps = 200;
    for (int k = -steps; k <= steps; ++k) {
        const double lag = 0.1 * shared * k / steps, squares = mean_square(ta, a, tb, b, lag);
        if (squares < least) least = squares, best = lag;
    }
    return best;
}

namespace {

/// One body in all sources, up to the end of the time that they all cover.
struct BodyInAll {
    std::string name;
    std::vector<BodyHistory> histories;  ///< one per source
    double end = HUGE_VAL;               ///< [s]

    std::string unit_of(const char* column) const {
        for (const BodyHistory& h : histories)
            if (h.has(column)) return h.table->find(column)->unit;
        return {};
    }
};

BodyInAll body_in_all(const std::vector<RunRecord>& sources, const std::string& name) {
    BodyInAll body{name, {}};
    for (const RunRecord& r : sources) {
        const auto found = r.tables.find(body_table(name));
        BodyHistory h;
        if (found != r.tables.end() && !found->second.time.empty()) {
            h.table = &found->second;
            body.end = std::min({body.end, h.table->time.back(), number_of(r, "duration", HUGE_VAL)});
        }
        body.histories.push_back(h);
    }
    for (BodyHistory& h : body.histories) h.end = body.end;
    return body;
}

/// A number of each source's body, shown and judged in a grid-convergence study; the last of the comparison's quantities.
Quantity& add_body_number(Comparison& comparison, const BodyInAll& body, const char* kind, std::string label,
                          std::string unit, std::string definition,
                          const std::function<double(const BodyHistory&)>& value_of) {
    Quantity q = new_quantity(fmt::format("body_{}:{}", kind, body.name), std::move(label), std::move(unit),
                              std::move(definition));
    for (const BodyHistory& h : body.histories) {
        MeanValue m;
        m.value = h.table ? value_of(h) : nan;
        m.known = std::isfinite(m.value);
        if (m.known)
            m.half_width = 0, m.from = h.table->time.front(), m.to = body.end;
        else
            m.why_not = h.table ? "its record has no value" : not_given;
        q.values.push_back(m);
    }
    beside(q);
    q.judged_in_grid_study = true;
    comparison.quantities.push_back(std::move(q));
    return comparison.quantities.back();
}

/// How far and how fast it has come down, and how far the sources' histories are apart. In waves they have no verdict:
/// they tell at which moment of a period the runs end.
void add_path(Comparison& comparison, const BodyInAll& body) {
    const std::vector<BodyHistory>& histories = body.histories;
    const bool in_waves =
        std::ranges::any_of(comparison.sources, [](const RunRecord& r) { return period_of_waves(r) > 0; });
    const std::string at = fmt::format("{} at {:.4g} s", body.name, body.end);
    Quantity& depth =
        add_body_number(comparison, body, "depth", "Way down of " + at, "m", "how far its centre of mass has come down",
                        [](const BodyHistory& h) { return start_of(h, "z") - h.at_end("z"); });
    depth.remark = of_every_pair(
        comparison.names, [&](std::size_t a, std::size_t b) { return rms_of_depths(histories[a], histories[b]); });
    depth.judged_in_grid_study = !in_waves;
    Quantity& speed = add_body_number(comparison, body, "speed", "Velocity downward of " + at, "m/s",
                                      "of its centre of mass", [](const BodyHistory& h) { return -h.at_end("vz"); });
    speed.judged_in_grid_study = !in_waves;
    speed.remark = of_every_pair(comparison.names, [&](std::size_t a, std::size_t b) {
        const BodyHistory &A = histories[a], &B = histories[b];
        if (!A.has("vz") || !B.has("vz")) return std::string();
        return fmt::format(
            "{} comes {:.3g} s later than {} (least difference of the velocities)", method_label(comparison.names[b]),
            lag_of(A.times(), A.values("vz"), B.times(), B.values("vz")), method_label(comparison.names[a]));
    });
}

/// Peak of the water's force, when it arrives, and its impulse.
void add_load(Comparison& comparison, const BodyInAll& body) {
    const std::vector<BodyHistory>& histories = body.histories;
    const std::string &name = body.name, N = body.unit_of("fz");
    const double filter = filter_of(comparison.sources, "body", name);
    const std::string over = fmt::format("over {:g} ms", 1e3 * filter);
    Quantity& peak =
        add_body_number(comparison, body, "peak", "Largest force on " + name + ", mean " + over, N,
                        "largest mean of the water's vertical force " + over + ": shorter peaks are sound and sampling",
                        [&](const BodyHistory& h) { return peak_of(h, filter); });
    for (std::size_t s = 0; s < histories.size(); ++s)
        if (const double shortest = sound_time(comparison.sources[s]); shortest > 0 && histories[s].has("fz")) {
            const BodyHistory& h = histories[s];
            const std::vector<double> lasts = lasting(h.times(), h.values("fz"), shortest);
            set_sound_aside(peak, s, largest_window_mean(h.times(), lasts, filter), shortest, comparison.names[s]);
        }
    add_body_number(comparison, body, "arrival", "Arrival of the force on " + name, "s",
                    "when the water's vertical force has risen to a tenth of its largest mean " + over,
                    [&](const BodyHistory& h) { return arrival_of(h, filter); });
    Quantity& impulse =
        add_body_number(comparison, body, "impulse", fmt::format("Impulse on {} at {:.4g} s", name, body.end), N + " s",
                        "integral of the water's vertical force", impulse_of);
    impulse.remark = of_every_pair(comparison.names, [&](std::size_t a, std::size_t b) {
        const MeanValue &A = impulse.values[a], &B = impulse.values[b];
        return A.known && B.known ? fmt::format("ratio {:.3g}", B.value / A.value) : std::string();
    });
}

}  // namespace

void add_bodies(Comparison& comparison) {
    std::set<std::string> names;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [table, content] : r.tables)
            if (table.starts_with("body_") && content.find("q0") && !content.time.empty())
                names.insert(table.substr(5));
    for (const std::string& name : names) {
        const BodyInAll body = body_in_all(comparison.sources, name);
        add_path(comparison, body);
        add_load(comparison, body);
        if (std::ranges::any_of(body.histories, [](const BodyHistory& h) { return turn_of(h) > 0.01; }))
            add_body_number(comparison, body, "turn", fmt::format("Turn of {} at {:.4g} s", name, body.end), "deg",
                            "angle between its attitude and that at the start", turn_of);
    }
}

void add_gauges(Comparison& comparison) {
    std::set<std::string> tables;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables)
            if (name.starts_with("body_") && std::ranges::any_of(table.columns, is_gauge)) tables.insert(name);
    for (const std::string& table : tables) {
        std::set<std::string> gauges;
        double end = HUGE_VAL;
        for (const RunRecord& r : comparison.sources) {
            const auto found = r.tables.find(table);
            if (found == r.tables.end() || found->second.time.empty()) continue;
            end = std::min(end, found->second.time.back());
            for (const Column& c : found->second.columns)
                if (is_gauge(c)) gauges.insert(c.name);
        }
        const std::string body = table.substr(5);
        for (const std::string& gauge : gauges) {
            Quantity q =
                new_quantity("strain_peak:" + body + ":" + gauge, fmt::format("Largest strain {} of {}", gauge, body),
                             "-", "the largest by magnitude, with its sign");
            for (const RunRecord& r : comparison.sources) q.values.push_back(peak_of(r, table, gauge, end));
            beside(q);
            q.judged_in_grid_study = true;
            comparison.quantities.push_back(std::move(q));
        }
    }
    const std::string unlike = unlike_structures(comparison);
    if (unlike.empty()) return;
    const std::string contained = "the difference contains the compliance";
    comparison.banners.push_back(
        fmt::format("The plate bends in the water in one run and not in the other ({}): of its forces, its motion and "
                    "its strains {}.",
                    unlike, contained));
    for (Quantity& q : comparison.quantities)
        if (q.name.starts_with("body_") || q.name.starts_with("strain_peak:")) q.caveat = contained;
}

}  // namespace tw
