#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ladder/ladder.h"
#include "compare/report/escape.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

std::string number(double v, const char* digits = "{:.5g}") {
    return std::isfinite(v) ? fmt::format(fmt::runtime(digits), v) : "-";
}

std::string sentence(const LadderQuantity& q) {
    std::string out = to_string(q.verdict);
    std::replace(out.begin(), out.end(), '_', ' ');
    if (std::isfinite(q.interval))
        out += fmt::format(" by {:+.4g} +- {:.3g} {} ({:+.1f} %)", q.difference, q.interval, q.unit, q.per_cent);
    else if (std::isfinite(q.difference))
        out += fmt::format("; the finest differ by {:+.4g} {} ({:+.1f} %)", q.difference, q.unit, q.per_cent);
    return q.reason.empty() ? out : out + ": " + for_terminal(q.reason);
}

}  // namespace

std::string ladder_text(const Ladder& ladder) {
    std::string out = fmt::format(
        "# {}\n\n| method | spacing at the hull [m] | particles or cells | wall time [s] |\n"
        "|---|---|---|---|\n",
        for_terminal(ladder.title));
    for (const LadderSide& side : ladder.sides)
        for (std::size_t i = 0; i < side.spacing.size(); ++i)
            out += fmt::format("| {} | {:g} | {:.3g} | {:.3g} |\n", for_terminal(side.method), side.spacing[i],
                               side.elements[i], side.seconds[i]);
    for (const LadderSide& side : ladder.sides)
        if (!side.similar)
            out += fmt::format("\n! The {} runs differ in more than their resolution: no family.\n",
                               for_terminal(side.method));
    for (const LadderQuantity& q : ladder.quantities) {
        if (std::all_of(q.values.begin(), q.values.end(), [](const LadderValue& v) { return v.levels.empty(); }))
            continue;
        out += fmt::format(
            "\n## {} [{}]\n\n| method | values, finest first | half width of the mean | order | class | U of the "
            "resolution | U |\n|---|---|---|---|---|---|---|\n",
            q.label, q.unit);
        std::string notes;
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const LadderValue& v = q.values[k];
            std::string values;
            for (const Level& l : v.levels) values += (values.empty() ? "" : ", ") + number(l.value);
            const double finest = v.levels.empty() ? 0 : std::abs(v.levels.front().value);
            out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", for_terminal(ladder.sides[k].method), values,
                               number(v.statistical, "{:.3g}"), number(v.estimate.order, "{:.2f}"),
                               to_string(v.estimate.convergence), number(v.estimate.uncertainty, "{:.3g}"),
                               std::isfinite(v.uncertainty) && finest > 0
                                   ? fmt::format("{:.3g} ({:.2g} %)", v.uncertainty, 100 * v.uncertainty / finest)
                                   : "-");
            for (const std::string& why : v.absent)
                notes += fmt::format("{} at {}\n", for_terminal(ladder.sides[k].method), for_terminal(why));
        }
        out += "\n" + (notes.empty() ? "" : notes + "\n") + q.label + ": " + sentence(q) + "\n";
    }
    return out;
}

std::string ladder_json(const Ladder& ladder) {
    Json sides = Json::array(), quantities = Json::array();
    for (const LadderSide& s : ladder.sides)
        sides.push_back({{"method", s.method},
                         {"spacing", s.spacing},
                         {"wall_seconds", s.seconds},
                         {"elements", s.elements},
                         {"similar", s.similar}});
    for (const LadderQuantity& q : ladder.quantities) {
        Json values = Json::array();
        for (const LadderValue& v : q.values) {
            Json levels = Json::array();
            for (const Level& l : v.levels) levels.push_back({{"spacing", l.spacing}, {"value", l.value}});
            values.push_back({{"levels", levels},
                              {"absent", v.absent},
                              {"statistical", v.statistical},
                              {"order", v.estimate.order},
                              {"class", to_string(v.estimate.convergence)},
                              {"resolution", v.estimate.uncertainty},
                              {"limit", v.estimate.limit},
                              {"uncertainty", v.uncertainty}});
        }
        quantities.push_back({{"name", q.name},
                              {"unit", q.unit},
                              {"values", values},
                              {"difference", q.difference},
                              {"interval", q.interval},
                              {"per_cent", q.per_cent},
                              {"verdict", to_string(q.verdict)},
                              {"reason", q.reason}});
    }
    const Json all = {
        {"title", ladder.title}, {"agree_within", ladder.agree_within}, {"sides", sides}, {"quantities", quantities}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string ladder_csv(const Ladder& ladder, std::size_t side) {
    const std::vector<double>& spacing = ladder.sides.at(side).spacing;
    std::string header = "near_hull [m]";
    std::vector<std::string> rows;
    for (const double h : spacing) rows.push_back(fmt::format("{:.9g}", h));
    for (const LadderQuantity& q : ladder.quantities) {
        const std::vector<Level>& levels = q.values[side].levels;
        if (levels.size() != spacing.size()) continue;
        header += fmt::format(",{} [{}]", q.name, q.unit);
        for (std::size_t i = 0; i < levels.size(); ++i) rows[i] += fmt::format(",{:.9g}", levels[i].value);
    }
    std::string out = header + "\n";
    for (const std::string& row : rows) out += row + "\n";
    return out;
}

}  // namespace tw
