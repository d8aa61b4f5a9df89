#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ablate/ablation.h"
#include "compare/report/csv.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;
using Seen = AblationChange::Seen;

/// For a cell of a markdown table: no line breaks, no bars.
std::string cell(const std::string& text) {
    std::string out = for_terminal(text);
    for (char& c : out)
        if (c == '\n' || c == '|') c = ' ';
    return out.empty() ? "-" : out;
}

const AblationChange* find(const AblationRow& row, const std::string& name) {
    const auto c = std::ranges::find(row.changes, name, &AblationChange::name);
    return c == row.changes.end() ? nullptr : &*c;
}

std::string label_of(const AblationMethod& method, const std::string& name) {
    for (const AblationRow& row : method.rows)
        if (const AblationChange* c = find(row, name)) return c->label;
    return name;
}

/// Every effect against the quantities that matter most.
std::string overview(const Ablation& ablation, const AblationMethod& method) {
    const std::vector<std::string> names = headline_of(method);
    std::string out = "| switched | against |", rule = "|---|---|";
    for (const std::string& name : names) {
        out += fmt::format(" {} |", cell(label_of(method, name)));
        rule += "---|";
    }
    out += " processor time | the plan's |\n" + rule + "---|---|\n";
    for (const AblationRow& row : method.rows) {
        const AblationRun& run = ablation.runs[row.run];
        out += fmt::format("| {} | {} |", cell(run.name), cell(ablation.runs[run.against].name));
        for (const std::string& name : names) {
            const AblationChange* c = find(row, name);
            const bool seen = c && c->seen == Seen::seen;
            out += fmt::format(" {0}{1}{0} |", seen ? "**" : "", c ? change_text(*c) : "–");
        }
        out += fmt::format(" {} | {} |\n", per_cent_text(row.cost), per_cent_text(row.predicted_cost));
    }
    return out;
}

std::string details(const Ablation& ablation, const AblationRow& row, const std::string& method) {
    const AblationRun& run = ablation.runs[row.run];
    std::string out = fmt::format("\n### {}: {}, against {}\n\n", for_terminal(method), for_terminal(run.name),
                                  for_terminal(ablation.runs[run.against].name));
    if (!row.influence.empty()) out += "The plan: " + for_terminal(row.influence) + "\n\n";
    out += "| quantity | before | after | change | | the plan's estimate |\n|---|---|---|---|---|---|\n";
    for (const AblationChange& c : row.changes)
        out += fmt::format("| {} [{}] | {} | {} | {} | {} | {} |\n", cell(c.label), cell(c.unit), mean_text(c.before),
                           mean_text(c.after), change_text(c), to_string(c.seen), cell(c.predicted));
    out +=
        fmt::format("| processor seconds per simulated second | {:.4g} | {:.4g} | {} | | {} |\n", row.processor_before,
                    row.processor_after, per_cent_text(row.cost), per_cent_text(row.predicted_cost));
    return out;
}

}  // namespace

std::string change_text(const AblationChange& c) {
    if (c.seen == Seen::not_known) return "–";
    if (c.seen == Seen::unchanged) return "unchanged";
    if (!std::isfinite(c.per_cent)) return signed_text(c.difference, c.interval) + " " + c.unit;
    if (!std::isfinite(c.per_cent_interval)) return per_cent_text(c.per_cent);
    return signed_text(c.per_cent, c.per_cent_interval) + " %";
}

std::string ablation_summary(const Ablation& ablation) {
    std::string out = fmt::format("# {}: one effect switched at a time\n", for_terminal(ablation.title));
    for (const AblationMethod& method : ablation.methods) {
        if (method.rows.empty()) continue;
        out += fmt::format("\n## {}\n\n{}", for_terminal(method.method), overview(ablation, method));
    }
    out +=
        "\nChanges in per cent of the value before, with their 95 % intervals; ** beyond the interval, which chance "
        "alone does once in twenty times. "
        "Processor time of one run each: a busy machine changes it by several per cent.\n";
    for (const AblationRun& run : ablation.runs)
        if (!run.why_not.empty())
            out += fmt::format("\n! {}: no result: {}\n", for_terminal(run.name), for_terminal(run.why_not));
    return out;
}

std::string ablation_text(const Ablation& ablation) {
    std::string out = ablation_summary(ablation);
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) out += details(ablation, row, method.method);
    return out;
}

std::string ablation_json(const Ablation& ablation) {
    Json runs = Json::array(), changes = Json::array(), costs = Json::array();
    for (const AblationRun& r : ablation.runs)
        runs.push_back({{"name", r.name},
                        {"effect", r.effect},
                        {"against", ablation.runs[r.against].name},
                        {"why_not", r.why_not}});
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) {
            const std::string& name = ablation.runs[row.run].name;
            for (const AblationChange& c : row.changes)
                changes.push_back({{"run", name},
                                   {"method", method.method},
                                   {"quantity", c.name},
                                   {"unit", c.unit},
                                   {"before", c.before.value},
                                   {"before_interval", c.before.half_width},
                                   {"after", c.after.value},
                                   {"after_interval", c.after.half_width},
                                   {"difference", c.difference},
                                   {"interval", c.interval},
                                   {"per_cent", c.per_cent},
                                   {"per_cent_interval", c.per_cent_interval},
                                   {"seen", to_string(c.seen)},
                                   {"predicted", c.predicted},
                                   {"remark", c.remark}});
            costs.push_back({{"run", name},
                             {"method", method.method},
                             {"processor_seconds_per_second_before", row.processor_before},
                             {"processor_seconds_per_second_after", row.processor_after},
                             {"per_cent", row.cost},
                             {"predicted_per_cent", row.predicted_cost},
                             {"steps_per_cent", row.steps}});
        }
    const Json all = {{"title", ablation.title}, {"runs", runs}, {"changes", changes}, {"costs", costs}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string ablation_csv(const Ablation& ablation) {
    const auto number = [](double v) { return std::isfinite(v) ? fmt::format("{:.9g}", v) : std::string(); };
    std::string out =
        "switched,against,method,quantity,unit,before,interval before,after,interval after,per cent,interval per "
        "cent,seen,predicted\n";
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) {
            const AblationRun& run = ablation.runs[row.run];
            const std::string head = csv_cell(run.name) + "," + csv_cell(ablation.runs[run.against].name) + "," +
                                     csv_cell(method.method) + ",";
            for (const AblationChange& c : row.changes)
                out += fmt::format("{}{},{},{},{},{},{},{},{},{},{}\n", head, csv_cell(c.name), csv_cell(c.unit),
                                   number(c.before.value), number(c.before.half_width), number(c.after.value),
                                   number(c.after.half_width), number(c.per_cent), number(c.per_cent_interval),
                                   to_string(c.seen), csv_cell(c.predicted));
            out += fmt::format("{}cost,s/s,{},,{},,{},,,{}\n", head, number(row.processor_before),
                               number(row.processor_after), number(row.cost), number(row.predicted_cost));
        }
    return out;
}

}  // namespace tw
