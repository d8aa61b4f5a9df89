#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/report/comparison_tables.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/report_table.h"
#include "compare/report/svg_plot.h"
#include "compare/sweep/sweep.h"
#include "compare/sweep/swept_curves.h"
#include "methods/methods.h"
#include "record/force_names.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

/// Values of the second method over those of the first, each with its intervals; the line of equal values.
std::string scatter_plot(const Sweep& sweep, const SweepSummary& s) {
    Plot plot;
    plot.title = s.label;
    plot.x_label = method_label(sweep.methods[s.a]) + " [" + s.unit + "]";
    plot.y_label = method_label(sweep.methods[s.b]) + " [" + s.unit + "]";
    plot.width = 460, plot.height = 400;
    double low = HUGE_VAL, high = 0;
    PlotLine dots{"", 0, {}, {}, false, false, true};
    for (const auto& p : s.points) {
        low = std::min({low, p.a, p.b}), high = std::max({high, p.a, p.b});
        if (!dots.x.empty()) dots.x.push_back(std::nan("")), dots.y.push_back(std::nan(""));
        dots.x.push_back(p.a), dots.y.push_back(p.b);
        if (std::isfinite(p.Ub))
            plot.lines.push_back({"", 0, {p.a, p.a}, {p.b - p.Ub, p.b + p.Ub}, false, false, false});
        if (std::isfinite(p.Ua))
            plot.lines.push_back({"", 0, {p.a - p.Ua, p.a + p.Ua}, {p.b, p.b}, false, false, false});
    }
    plot.lines.push_back({"equal", 1, {low, high}, {low, high}, false, true, false});
    plot.lines.push_back(std::move(dots));
    return "<figure>" + svg(plot) + "</figure>";
}

/// Bias and scatter between the methods, a row for each quantity.
ReportTable bias_and_scatter(const Sweep& sweep) {
    if (sweep.methods.size() < 2) return {};
    const bool matrix = sweep.methods.size() > 2;
    ReportTable table{"Bias and scatter between the methods", {words("Quantity"), words("unit"), numbers("scenes")}};
    if (matrix) table.columns.push_back(words("methods"));
    for (const std::string& name :
         {matrix ? "bias" : "bias, " + method_label(sweep.methods[1]) + " over " + method_label(sweep.methods[0]),
          std::string("its 95 % interval"), std::string("scatter"), std::string("left out")})
        table.columns.push_back(numbers(name));
    for (const SweepSummary& s : sweep.summaries) {
        ReportRow row{{s.label, s.unit, s.points.size()}};
        if (matrix)
            row.cells.emplace_back(method_label(sweep.methods[s.b]) + " over " + method_label(sweep.methods[s.a]));
        row.cells.emplace_back(ratio_text(s.bias));
        row.cells.emplace_back(std::isfinite(s.interval)
                                   ? ratio_text(s.bias - s.interval) + " … " + ratio_text(s.bias + s.interval)
                                   : "–");
        row.cells.emplace_back(std::isfinite(s.scatter) ? factor_text(std::exp(s.scatter)) : "–");
        row.cells.emplace_back(s.left_out);
        table.rows.push_back(std::move(row));
    }
    table.notes.push_back(
        "Bias: mean of the logarithm of the ratio, as a percentage. Scatter: factor of its standard deviation. Left "
        "out: a value is missing or 0, or the signs differ.");
    std::string plots;
    for (const SweepSummary& s : sweep.summaries)
        if (!s.points.empty()) plots += scatter_plot(sweep, s);
    if (!plots.empty()) table.picture = "<div class=\"pair\">" + plots + "</div>";
    return table;
}

/// Every quantity, scene by scene.
ReportTable scene_by_scene(const Sweep& sweep) {
    if (sweep.methods.size() < 2) return {};
    const bool matrix = sweep.methods.size() > 2;
    ReportTable table{"Scene by scene", {words("Quantity"), words("unit"), words("Scene")}};
    if (matrix) table.columns.push_back(words("methods"));
    for (const std::string& name : matrix ? std::vector<std::string>{"the second", "the first"}
                                          : std::vector{method_label(sweep.methods[0]), method_label(sweep.methods[1])})
        table.columns.push_back(numbers(name));
    for (const ReportColumn& column : {numbers("relative"), words("verdict"), words("discretisation error")})
        table.columns.push_back(column);
    for (const SweepSummary& s : sweep.summaries)
        for (const auto& p : s.points) {
            const SweepMember& member = sweep.members[p.member];
            ReportRow row{{s.label, s.unit, member.name}};
            if (matrix)
                row.cells.emplace_back(method_label(sweep.methods[s.a]) + ", " + method_label(sweep.methods[s.b]));
            row.cells.emplace_back(value_text(p.a, p.Ua));
            row.cells.emplace_back(value_text(p.b, p.Ub));
            const double ratio = p.b / p.a;
            row.cells.emplace_back(std::abs(std::log(ratio)) > std::log(10)
                                       ? factor_text(ratio)
                                       : per_cent_text(100 * (ratio - 1), 100 * p.U / std::abs(p.a)));
            row.cells.push_back(verdict_cell(p.verdict));
            row.cells.emplace_back(p.verdict == Verdict::not_estimated ? "not estimated" : member.discretisation_from);
            table.rows.push_back(std::move(row));
        }
    table.notes.push_back(
        "± is the 95 % interval. Where the discretisation error is not estimated it holds the statistical scatter of "
        "the means alone; where it is from another scene's coarser runs it was taken relative to the values.");
    return table;
}

/// The scenes, with the reason where there is no comparison.
ReportTable the_scenes(const Sweep& sweep) {
    ReportTable table{"The scenes", {words("Scene"), words("comparison"), words("report or reason")}};
    for (const SweepMember& m : sweep.members)
        table.rows.push_back({{m.name, m.why_not.empty() ? ReportCell("yes") : ReportCell("no comparison", Mark::open),
                               m.why_not.empty() ? m.report : m.why_not}});
    std::string links;
    for (const SweepMember& m : sweep.members)
        if (!m.report.empty())
            links += fmt::format("<li><a href=\"{}\">{}</a></li>", escaped(m.report), escaped(m.name));
    if (!links.empty()) table.picture = "<p>Reports:</p><ul>" + links + "</ul>";
    return table;
}

/// What the page and the terminal say of a sweep.
std::vector<ReportTable> tables_of(const Sweep& sweep) {
    std::vector<ReportTable> tables = swept_curves(sweep);
    for (ReportTable table : {bias_and_scatter(sweep), scene_by_scene(sweep), the_scenes(sweep)})
        tables.push_back(std::move(table));
    return tables;
}

}  // namespace

std::string ratio_text(double logarithm) {
    if (!std::isfinite(logarithm)) return "–";
    if (std::abs(logarithm) > std::log(10)) return factor_text(std::exp(logarithm));
    return per_cent_text(100 * std::expm1(logarithm));
}

std::string sweep_text(const Sweep& sweep) {
    return fmt::format("# {}\n", for_terminal(sweep.title)) + text_of(tables_of(sweep));
}

std::string sweep_html(const Sweep& sweep) {
    const auto good = std::ranges::count_if(sweep.members, [](const SweepMember& m) { return m.why_not.empty(); });
    return page_begin_with(sweep.title, fmt::format("{} scenes, {} compared", sweep.members.size(), good)) +
           html_of(tables_of(sweep)) + page_end;
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
