#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ablate/ablation_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;
using Seen = AblationChange::Seen;

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
    for (const AblationMethod& method : ablation.methods)
        if (!method.rows.empty()) out += "\n" + text_of(ablation_overview(ablation, method));
    out += std::string("\n") + ablation_note + "\n";
    if (const ReportTable missing = ablation_missing(ablation); !missing.empty()) out += "\n" + text_of(missing);
    return out;
}

std::string ablation_text(const Ablation& ablation) {
    std::string out = ablation_summary(ablation);
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows)
            out += "\n" + text_of(ablation_details(ablation, row, method.method));
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
    ReportTable table;
    for (const char* name : {"switched", "against", "method", "quantity", "unit", "before", "interval before", "after",
                             "interval after", "per cent", "interval per cent", "seen", "predicted"})
        table.columns.push_back(words(name));
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) {
            const AblationRun& run = ablation.runs[row.run];
            const std::string& against = ablation.runs[run.against].name;
            for (const AblationChange& c : row.changes)
                table.rows.push_back({{run.name, against, method.method, c.name, c.unit, c.before.value,
                                       c.before.half_width, c.after.value, c.after.half_width, c.per_cent,
                                       c.per_cent_interval, to_string(c.seen), c.predicted}});
            table.rows.push_back({{run.name, against, method.method, "cost", "s/s", row.processor_before, "",
                                   row.processor_after, "", row.cost, "", "", row.predicted_cost}});
        }
    return csv_of(table);
}

}  // namespace tw
