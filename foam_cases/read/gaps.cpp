#include "foam_cases/read/gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "foam_cases/read/number_rows.h"

namespace tw {
namespace {

/// A time at which a row has to stand, and how far from it the row may be: the log and the tables round differently
/// [s].
struct Due {
    double time, tolerance;
};

std::vector<Due> steps_of(const SolverLog& log, double until) {
    std::vector<Due> due;
    double before = 0;
    for (const SolverLog::Step& step : log.steps()) {
        if (step.time > until * (1 + time_name_precision)) break;
        due.push_back({step.time, 0.3 * (step.time - before)});
        before = step.time;
    }
    return due;
}

std::vector<Due> write_times(double interval, double until) {
    std::vector<Due> due;
    for (int k = 1; k <= until / interval + 1e-4; ++k) due.push_back({k * interval, 1e-3 * interval});
    return due;
}

std::optional<Gap> gap_in(const RunRecord& record, const std::string& table, const std::vector<Due>& due,
                          const char* kind) {
    static const std::vector<double> none;
    const auto found = record.tables.find(table);
    const std::vector<double>& rows = found == record.tables.end() ? none : found->second.time;
    std::size_t met = 0;
    double first = 0;
    auto row = rows.begin();
    for (const Due& d : due) {
        row = std::lower_bound(row, rows.end(), d.time - d.tolerance);
        if (row != rows.end() && *row <= d.time + d.tolerance)
            ++met;
        else if (first == 0)
            first = d.time;
    }
    if (met == due.size()) return {};
    return Gap{first, fmt::format("{} has rows for {} of {} {}, the first is missing at t = {:.6g} s", table, met,
                                  due.size(), kind, first)};
}

/// Rows at the steps nearest to the write times are at most an interval and a step apart. `longest` step [s].
std::optional<Gap> apart_in(const RunRecord& record, const std::string& table, double interval, double longest,
                            double until) {
    const auto found = record.tables.find(table);
    std::vector<double> rows{0};
    if (found != record.tables.end()) rows.insert(rows.end(), found->second.time.begin(), found->second.time.end());
    // A run ends within half a step of its duration, and its last write time may lie an interval before.
    rows.push_back(until);
    const double most = interval + 1.01 * longest;
    const auto gap = std::adjacent_find(rows.begin(), rows.end(), [&](double a, double b) { return b - a > most; });
    if (gap == rows.end()) return {};
    return Gap{*gap + interval, fmt::format("{} has no row from t = {:.6g} to {:.6g} s, expected one every {:.6g} s",
                                            table, *gap, *std::next(gap), interval)};
}

}  // namespace

std::optional<Gap> first_gap(const CasePlan& plan, const SolverLog& log, const RunRecord& record, double until) {
    const Scene& scene = *plan.scene;
    const double interval = record.numbers.at("write_interval");
    const std::vector<Due> steps = steps_of(log, until), writes = write_times(interval, until);
    double longest = log.steps().empty() ? interval / 2 : 0;  // without a log it is not known
    for (const SolverLog::Step& step : log.steps()) longest = std::max(longest, step.step);
    std::optional<Gap> earliest;
    const auto keep_earlier = [&](std::optional<Gap> gap) {
        if (gap && (!earliest || gap->time < earliest->time)) earliest = std::move(gap);
    };
    const auto look = [&](bool wanted, const char* table, const std::vector<Due>& due, const char* kind) {
        if (wanted) keep_earlier(gap_in(record, table, due, kind));
    };
    const bool loaded = scene.hull || (!plan.solids.empty() && record.attributes.contains(loads_of));
    look(loaded, "forces_total", steps, "time steps");
    for (const BodyInMesh& b : plan.bodies) look(true, plan.motion_table(b).c_str(), steps, "time steps");
    look(!scene.sampling.pressure.empty(), "pressure", steps, "time steps");
    look(!scene.sampling.height.empty(), "height", steps, "time steps");
    for (const char* table : {"samples", "forces"}) {
        if (table == std::string("forces") && !loaded) continue;
        if (plan.writes_at_steps)
            keep_earlier(apart_in(record, table, interval, longest, until));
        else
            look(true, table, writes, "write times");
    }
    return earliest;
}

bool lacks_picture(const CasePlan& plan, const RunRecord& record) {
    return plan.scene->hull && record.hull_pressure.empty();
}

}  // namespace tw
