#include "statistics/settled_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "record/record_numbers.h"
#include "statistics/approach.h"
#include "statistics/flow_through.h"
#include "statistics/settled_mean.h"
#include "statistics/time_bins.h"
#include "statistics/whole_periods.h"
#include "text/plain_number.h"

namespace tw {
namespace {

const std::vector<double>& frames_of(const RunRecord& record) {
    static const std::vector<double> none;
    const auto samples = record.tables.find("samples");
    return samples == record.tables.end() ? none : samples->second.time;
}

/// Whether frame number `k`, counted from 1, is one at which the rule is looked at.
bool looks_at(const std::vector<double>& frames, std::size_t k, double from, const SettledStop& rule) {
    if (k < 2 || k > frames.size()) return false;
    if (rule.period > 0) {
        const auto periods = [&](double t) { return whole_periods(from, t, rule.period); };
        return periods(frames[k - 1]) >= 2 && periods(frames[k - 1]) > periods(frames[k - 2]);
    }
    const auto grown = [&](std::size_t n) {
        return std::floor(std::log(static_cast<double>(n)) / std::log1p(rule.between_looks));
    };
    return grown(k) > grown(k - 1);
}

/// A column up to a time.
struct LoadSeries {
    std::span<const double> time, values;
    LoadSeries until(double end) const {
        const auto n =
            static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), end * (1 + 1e-9)) - time.begin());
        return {time.first(n), values.first(n)};
    }
    LoadSeries after(double begin) const {
        const auto n = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), begin) - time.begin());
        return {time.subspan(n), values.subspan(n)};
    }
    double mean() const { return time_integral(time, values) / (time.back() - time.front()); }
};

std::optional<LoadSeries> series_of(const RunRecord& record, const char* table, const std::string& column) {
    const Column* c = record.series(table, column);
    if (!c) return {};
    return LoadSeries{record.tables.at(table).time, c->values};
}

/// The rule at one look.
class Look {
public:
    Look(const RunRecord& record, const SettledStop& rule, double end) : record_(record), rule_(rule), end_(end) {
        rules_.from = number_of(record, "mean_from", 0);
        rules_.flow_through = flow_through_time(record);
    }

    SettledLoads all() const {
        SettledLoads out;
        const double length = number_of(record_, "length", 0);
        double lift = 0;
        for (const auto& [column, name] : {std::pair{"fz", "lift"}, {"fx", "drag"}, {"my", "trim moment"}}) {
            const std::optional<LoadSeries> series = series_of(record_, "forces", column);
            if (!series) continue;
            const bool moment = column == std::string_view("my");
            SettledRules rules = rules_;
            if (moment) rules.allowed_error = 1e-3 * lift * length;
            const LoadSeries so_far = series->until(end_);
            const SettledMean mean = settled_mean(so_far.time, so_far.values, rules);
            if (!moment && out.means.empty()) lift = mean.known ? std::abs(mean.value) : 0;
            out.means.push_back(load(name, so_far, mean, moment ? 0.1 * lift * length : 0));
        }
        const bool any = !out.means.empty();
        add_known(out, "samples", "wetted_length", "wetted length", 0.5 * number_of(record_, "near_hull", 0));
        for (const char* table : {"pressure", "height"})
            if (const auto probes = record_.tables.find(table); probes != record_.tables.end())
                for (const Column& c : probes->second.columns)
                    add_known(out, table, c.name, table + (" at " + c.name), 0);
        out.settled = any && std::ranges::all_of(out.means, &LoadMean::settled);
        return out;
    }

private:
    LoadMean load(const char* name, const LoadSeries& series, const SettledMean& mean, double least_scale) const {
        LoadMean m{.name = name, .still = {}};
        if (!mean.known) {
            m.still = mean.why_not;
            return m;
        }
        const double scale = std::max(std::abs(mean.value), least_scale);
        m.share = mean.half_width / scale;
        if (!(m.share <= rule_.interval)) {
            m.still = fmt::format("known to {} %, {} % wanted", plain_number(100 * m.share, 2),
                                  plain_number(100 * rule_.interval, 2));
            return m;
        }
        const LoadSeries counted = series.after(rules_.from * (1 - 1e-9));
        const Approach approach = approach_of(counted.time, counted.values, mean.from);
        if (!(approach.lacking + approach.error <= rule_.lacking * scale)) {
            m.still = fmt::format("an approach to its end may lack {} % of it, {} % allowed",
                                  plain_number(100 * (approach.lacking + approach.error) / scale, 2),
                                  plain_number(100 * rule_.lacking, 2));
            return m;
        }
        if (rule_.period > 0) {
            const double last = series.after(end_ - rule_.period).mean(),
                         two = series.after(end_ - 2 * rule_.period).mean();
            if (!(std::abs(last - two) <= rule_.interval * scale)) {
                m.still = fmt::format("the means over its last wave period and over two differ by {} %",
                                      plain_number(100 * std::abs(last - two) / scale, 2));
                return m;
            }
        }
        m.settled = true;
        return m;
    }

    /// A mean that only has to be known, where more time would make it known.
    void add_known(SettledLoads& out, const char* table, const std::string& column, const std::string& name,
                   double allowed_error) const {
        const std::optional<LoadSeries> series = series_of(record_, table, column);
        if (!series) return;
        SettledRules rules = rules_;
        rules.allowed_error = allowed_error;
        const LoadSeries so_far = series->until(end_);
        const SettledMean mean = settled_mean(so_far.time, so_far.values, rules);
        if (!mean.known && mean.seconds_needed > 0) out.means.push_back({.name = name, .still = mean.why_not});
    }

    const RunRecord& record_;
    const SettledStop& rule_;
    double end_;
    SettledRules rules_;
};

}  // namespace

std::string SettledLoads::sentence() const {
    std::string known;
    for (const LoadMean& m : means) {
        if (!m.settled) return m.name + ": " + m.still;
        known += fmt::format("{}{} to {} %", known.empty() ? "" : ", ", m.name, plain_number(100 * m.share, 2));
    }
    return known.empty() ? "it has no loads" : "known: " + known;
}

void widen_where_ended(const RunRecord& record, SettledMean& mean, double least_scale) {
    if (!mean.known || text_of(record, ended_by) != by_settling) return;
    const double least = SettledStop::known_to * std::max(std::abs(mean.value), least_scale);
    if (mean.half_width >= least) return;
    mean.half_width = least;
    mean.limited_by = "the rule that ended the run";
}

bool is_look(const RunRecord& record, const SettledStop& rule) {
    const std::vector<double>& frames = frames_of(record);
    const double from = number_of(record, "mean_from", 0);
    return looks_at(frames, frames.size(), from, rule) &&
           frames.back() - from >= SettledRules{}.fewest_flow_throughs * flow_through_time(record);
}

SettledLoads settled_loads(const RunRecord& record, const SettledStop& rule) {
    const std::vector<double>& frames = frames_of(record);
    if (frames.empty()) return {};
    SettledLoads now = Look(record, rule, frames.back()).all();
    if (!now.settled || rule.period > 0) return now;
    std::size_t k = frames.size() - 1;
    while (k > 0 && !looks_at(frames, k, 0, rule)) --k;
    if (k == 0) return {};
    const SettledLoads before = Look(record, rule, frames[k - 1]).all();
    return before.settled ? now : before;
}

}  // namespace tw
