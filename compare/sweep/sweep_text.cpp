#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/report/csv.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/sweep/sweep.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string ratio_text(double logarithm) {
    if (!std::isfinite(logarithm)) return "–";
    if (std::abs(logarithm) > std::log(10)) return fmt::format("× {:.2g}", std::exp(logarithm));
    return per_cent_text(100 * std::expm1(logarithm));
}

std::string sweep_text(const Sweep& sweep) {
    std::string out = fmt::format("# {}\n", for_terminal(sweep.title));
    if (sweep.methods.size() == 2) {
        out += fmt::format(
            "\n| quantity | scenes | bias, {1} over {0} | its 95 % interval | scatter | left out |\n"
            "|---|---|---|---|---|---|\n",
            for_terminal(sweep.methods[0]), for_terminal(sweep.methods[1]));
        for (const SweepSummary& s : sweep.summaries)
            out += fmt::format(
                "| {} | {} | {} | {} | {} | {} |\n", s.label, s.points.size(), ratio_text(s.bias),
                std::isfinite(s.interval)
                    ? fmt::format("{} to {}", ratio_text(s.bias - s.interval), ratio_text(s.bias + s.interval))
                    : "-",
                std::isfinite(s.scatter) ? fmt::format("x {:.3g}", std::exp(s.scatter)) : "-", s.left_out);
    }
    for (const SweepSummary& s : sweep.summaries) {
        if (s.points.empty()) continue;
        out += fmt::format("\n## {} [{}]\n\n| scene | {} | {} | relative | verdict |\n|---|---|---|---|---|\n", s.label,
                           s.unit, for_terminal(sweep.methods[0]), for_terminal(sweep.methods[1]));
        for (const auto& p : s.points)
            out += fmt::format("| {} | {} | {} | {} | {} |\n", for_terminal(sweep.members[p.member].name),
                               value_text(p.a, p.Ua), value_text(p.b, p.Ub), per_cent_text(100 * (p.b / p.a - 1)),
                               verdict_label(p.verdict));
    }
    for (const SweepMember& m : sweep.members)
        if (!m.why_not.empty())
            out += fmt::format("\n! {}: no comparison: {}\n", for_terminal(m.name), for_terminal(m.why_not));
    return out;
}

std::string sweep_json(const Sweep& sweep) {
    Json members = Json::array(), summaries = Json::array();
    for (const SweepMember& m : sweep.members)
        members.push_back({{"name", m.name}, {"report", m.report}, {"why_not", m.why_not}});
    for (const SweepSummary& s : sweep.summaries) {
        Json points = Json::array();
        for (const auto& p : s.points)
            points.push_back({{"scene", sweep.members[p.member].name},
                              {"a", p.a},
                              {"b", p.b},
                              {"interval_a", p.Ua},
                              {"interval_b", p.Ub},
                              {"verdict", to_string(p.verdict)}});
        summaries.push_back({{"name", s.name},
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
    std::string out = "scene,quantity,unit,value A,value B,interval A,interval B,verdict\n";
    for (const SweepSummary& s : sweep.summaries)
        for (const auto& p : s.points)
            out += fmt::format("{},{},{},{:.9g},{:.9g},{:.4g},{:.4g},{}\n", csv_cell(sweep.members[p.member].name),
                               s.name, s.unit, p.a, p.b, p.Ua, p.Ub, to_string(p.verdict));
    return out;
}

}  // namespace tw
