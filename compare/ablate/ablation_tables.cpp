#include "compare/ablate/ablation_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw {

namespace {

using Seen = AblationChange::Seen;

/// What was seen stands out, what was not stays pale.
Mark mark_of(Seen seen) {
    switch (seen) {
        case Seen::seen: return Mark::bad;
        case Seen::nothing:
        case Seen::unchanged: return Mark::good;
        case Seen::no_interval: return Mark::open;
        case Seen::not_known: break;
    }
    return Mark::faint;
}

}  // namespace

const AblationChange* change_in(const AblationRow& row, const std::string& name) {
    const auto c = std::ranges::find(row.changes, name, &AblationChange::name);
    return c == row.changes.end() ? nullptr : &*c;
}

std::string change_label(const AblationMethod& method, const std::string& name) {
    for (const AblationRow& row : method.rows)
        if (const AblationChange* c = change_in(row, name)) return c->label;
    return name;
}

ReportTable ablation_overview(const Ablation& ablation, const AblationMethod& method) {
    const std::vector<std::string> names = headline_of(method);
    ReportTable table{method_label(method.method), {words("Switched"), words("compared with")}};
    for (const std::string& name : names) table.columns.push_back(numbers(change_label(method, name)));
    table.columns.push_back(numbers("processor time"));
    table.columns.push_back(numbers("predicted"));
    for (const AblationRow& row : method.rows) {
        const AblationRun& run = ablation.runs[row.run];
        ReportRow line{{run.name, ablation.runs[run.against].name}};
        for (const std::string& name : names) {
            const AblationChange* c = change_in(row, name);
            line.cells.emplace_back(c ? change_text(*c) : "–", c && c->seen == Seen::seen ? Mark::bad : Mark::none);
        }
        line.cells.emplace_back(per_cent_text(row.cost));
        line.cells.emplace_back(per_cent_text(row.predicted_cost));
        table.rows.push_back(std::move(line));
    }
    return table;
}

ReportTable ablation_details(const Ablation& ablation, const AblationRow& row, const std::string& method) {
    const AblationRun& run = ablation.runs[row.run];
    ReportTable table{
        fmt::format("{}: {}, compared with {}", method_label(method), run.name, ablation.runs[run.against].name),
        {words("Quantity"), words("unit"), numbers("before"), numbers("after"), numbers("change"), words(""),
         words("the plan's estimate")}};
    for (const AblationChange& c : row.changes)
        table.rows.push_back({{c.label, c.unit, mean_text(c.before), mean_text(c.after), change_text(c),
                               ReportCell(to_string(c.seen), mark_of(c.seen)), c.predicted},
                              c.remark});
    table.rows.push_back(
        {{"Processor time of solving", "s/s", value_text(row.processor_before, 0), value_text(row.processor_after, 0),
          per_cent_text(row.cost), std::isfinite(row.steps) ? "time steps: " + per_cent_text(row.steps) : "",
          per_cent_text(row.predicted_cost)}});
    if (!row.influence.empty()) table.notes.push_back("The plan: " + row.influence);
    return table;
}

ReportTable ablation_missing(const Ablation& ablation) {
    ReportTable table{"Without a result", {words("Switched"), words("reason")}};
    for (const AblationRun& run : ablation.runs)
        if (!run.why_not.empty()) table.rows.push_back({{run.name, run.why_not}});
    return table;
}

}  // namespace tw
