#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/sweep/sweep_tables.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string ratio_text(double logarithm) {
    if (!std::isfinite(logarithm)) return "–";
    if (std::abs(logarithm) > std::log(10)) return factor_text(std::exp(logarithm));
    return per_cent_text(100 * std::expm1(logarithm));
}

std::string sweep_text(const Sweep& sweep) {
    std::string out = fmt::format("# {}\n", for_terminal(sweep.title));
    const auto add = [&](const ReportTable& table) {
        if (!table.empty()) out += "\n" + text_of(table);
    };
    add(sweep_summaries(sweep));
    add(sweep_values(sweep));
    add(sweep_scenes(sweep));
    return out;
}

std::string sweep_json(const Sweep& sweep) {
    Json members = Json::array(), summaries = Json::array();
    for (const SweepMember& m : sweep.members)
        members.push_back({{"name", m.name},
                           {"report", m.report},
                           {"why_not", m.why_not},
                           {"discretisation_from", m.discretisation_from}});
    for (const SweepSummary& s : sweep.summaries) {
        Json points = Json::array();
        for (const auto& p : s.points)
            points.push_back({{"scene", sweep.members[p.member].name},
                              {"a", p.a},
                              {"b", p.b},
                              {"interval_a", p.Ua},
                              {"interval_b", p.Ub},
                              {"interval", p.U},
                              {"verdict", to_string(p.verdict)}});
        Json& summary = summaries.emplace_back();
        if (sweep.methods.size() > 2) summary["methods"] = {sweep.methods[s.a], sweep.methods[s.b]};
        summary.update({{"name", s.name},
                        {"unit", s.unit},
                        {"bias", s.bias},
                        {"interval", s.interval},
                        {"scatter", s.scatter},
                        {"left_out", s.left_out},
                        {"points", points}});
    }
    const Json all = {
        {"title", sweep.title}, {"methods", sweep.methods}, {"scenes", members}, {"quantities", summaries}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string sweep_csv(const Sweep& sweep) {
    ReportTable table{
        "",
        {words("scene"), words("quantity"), words("unit"), numbers("value A"), numbers("value B"),
         numbers("interval A"), numbers("interval B"), words("verdict"), words("discretisation error from")}};
    const bool matrix = sweep.methods.size() > 2;
    if (matrix) table.columns.push_back(words("A")), table.columns.push_back(words("B"));
    for (const SweepSummary& s : sweep.summaries)
        for (const auto& p : s.points) {
            ReportRow row{{sweep.members[p.member].name, s.name, s.unit, p.a, p.b, p.Ua, p.Ub, to_string(p.verdict),
                           sweep.members[p.member].discretisation_from}};
            if (matrix) row.cells.insert(row.cells.end(), {sweep.methods[s.a], sweep.methods[s.b]});
            table.rows.push_back(std::move(row));
        }
    return csv_of(table);
}

}  // namespace tw
