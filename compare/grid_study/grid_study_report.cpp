#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/report/svg_plot.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "record/force_names.h"

namespace tw {

namespace {

/// One of many beside each other: what its axes and colours mean stands once, around the row.
void make_small(Plot& plot) { plot.width = 260, plot.height = 180; }

/// Values over spacing with their intervals, and where the fit points at spacing 0.
std::string convergence_plot(const GridStudyQuantity& q) {
    Plot plot;
    plot.title = q.label + (q.unit == "-" ? "" : " [" + unit_text(q.unit) + "]");
    make_small(plot);
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const GridStudyValue& v = q.values[k];
        PlotLine line{"", k, {}, {}, false, false, true};
        for (const StudyLevel& l : v.levels) line.x.push_back(l.h), line.y.push_back(l.value);
        if (line.x.empty()) continue;
        if (std::isfinite(v.estimate.limit))
            plot.lines.push_back({"", k, {0, line.x.front()}, {v.estimate.limit, line.y.front()}, false, true, false});
        if (std::isfinite(v.uncertainty))
            plot.lines.push_back({"",
                                  k,
                                  {line.x.front(), line.x.front()},
                                  {line.y.front() - v.uncertainty, line.y.front() + v.uncertainty},
                                  false,
                                  false,
                                  false});
        plot.lines.push_back(std::move(line));
    }
    return svg(plot);
}

/// The uncertainty of each level over its wall time, with the fitted line drawn on to 1 % of the value.
std::string cost_plot(const GridStudyQuantity& q) {
    Plot plot;
    plot.title = "U of " + lower_case_first(q.label) + (q.unit == "-" ? "" : " [" + unit_text(q.unit) + "]");
    make_small(plot);
    plot.log_x = plot.log_y = true;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const GridStudyValue& v = q.values[k];
        PlotLine line{"", k, {}, {}, false, false, true};
        for (const CostPoint& p : v.cost.points) line.x.push_back(p.seconds), line.y.push_back(p.uncertainty);
        if (line.x.empty()) continue;
        if (v.cost.known()) {
            const double last = std::clamp(v.cost.seconds_for(0.01 * q.size), line.x.front(), 100 * line.x.front());
            PlotLine fit{"", k, {line.x.back(), last}, {}, false, true, false};
            for (const double seconds : fit.x) fit.y.push_back(v.cost.uncertainty_after(seconds));
            plot.lines.push_back(std::move(fit));
        }
        plot.lines.push_back(std::move(line));
    }
    if (plot.lines.empty()) return {};
    for (const double share : {0.05, 0.02, 0.01})
        plot.levels.push_back({fmt::format("{:g} %", 100 * share), share * q.size});
    return svg(plot);
}

/// One row of small plots, as many as are wide enough to be read; the page scrolls it sideways.
std::string row_of(const std::vector<std::string>& plots) {
    std::string out;
    for (const std::string& plot : plots) out += "<figure>" + plot + "</figure>";
    return out.empty() ? out : "<div class=\"multiples\">" + out + "</div>";
}

std::string plots(const GridStudy& grid_study) {
    std::vector<const GridStudyQuantity*> all = main_quantities(grid_study.quantities);
    for (const GridStudyQuantity& q : grid_study.quantities)
        if (!is_main_quantity(q.name)) all.push_back(&q);
    std::vector<std::string> values, costs;
    for (const GridStudyQuantity* q : all)
        if (std::ranges::any_of(q->values, [](const GridStudyValue& v) { return v.levels.size() > 2; })) {
            values.push_back(convergence_plot(*q));
            if (std::string cost = cost_plot(*q); !cost.empty()) costs.push_back(std::move(cost));
        }
    if (values.empty()) return {};
    std::string keys;
    for (std::size_t k = 0; k < grid_study.sides.size(); ++k)
        keys += fmt::format("<span class=\"key k{}\"></span>{} ", k, escaped(method_label(grid_study.sides[k].method)));
    return "<h2>Convergence, and accuracy over time</h2><p class=\"sub\">" + keys + "</p>" + row_of(values) +
           "<p class=\"note\">Over the spacing at the hull [m]: bars are the 95 % interval of the finest value, broken "
           "lines lead to the estimate for spacing 0.</p>" +
           row_of(costs) +
           (costs.empty() ? ""
                          : "<p class=\"note\">Over the wall time that each size took, everything counted [s]: its "
                            "interval (discretisation and statistics); broken: the fitted line.</p>");
}

}  // namespace

std::vector<std::string> grid_study_banners(const GridStudy& grid_study) {
    std::vector<std::string> lines;
    for (const GridStudySide& side : grid_study.sides)
        if (!side.similar)
            lines.push_back("The " + method_label(side.method) +
                            " runs differ in more than their resolution: they do not form a family.");
    for (const auto* list : {&grid_study.notes, &grid_study.left_out})
        lines.insert(lines.end(), list->begin(), list->end());
    return lines;
}

std::string grid_study_sentence(const GridStudy& grid_study, const GridStudyQuantity& q, const GridStudyDifference& d) {
    return for_terminal(sentence_of(statement_of(grid_study, q, d)));
}

std::string grid_study_sentence(const GridStudy& grid_study, const GridStudyQuantity& q) {
    return grid_study_sentence(grid_study, q, q);
}

std::string grid_study_summary(const GridStudy& grid_study) {
    std::string out;
    for (const GridStudyQuantity* q : main_quantities(grid_study.quantities))
        for (const GridStudyDifference& d : q->differences()) out += grid_study_sentence(grid_study, *q, d) + "\n";
    out += text_of(std::vector<ReportTable>{grid_study_verdicts(grid_study), grid_study_held(grid_study),
                                            grid_study_checks(grid_study)});
    for (const std::string& line : grid_study_banners(grid_study)) out += "\n! " + for_terminal(line) + "\n";
    return out;
}

std::string grid_study_text(const GridStudy& grid_study) {
    std::string out = fmt::format("# {}\n\n", for_terminal(grid_study.title)) + grid_study_summary(grid_study) + "\n";
    for (const GridStudyQuantity& q : grid_study.quantities)
        if (!is_main_quantity(q.name))
            for (const GridStudyDifference& d : q.differences())
                out += "- " + grid_study_sentence(grid_study, q, d) + "\n";
    out += text_of(grid_study_details(grid_study));
    if (grid_study_held(grid_study).empty())
        for (const std::string& line : grid_study.calibrated)
            out += "\nTuned, not validated: " + for_terminal(line) + "\n";
    return out;
}

std::string grid_study_html(const GridStudy& grid_study) {
    std::string out = html_of(grid_study_held(grid_study));
    if (out.empty())
        for (const std::string& line : grid_study.calibrated)
            out += "<p class=\"note\">Tuned, not validated: " + escaped(line) + "</p>";
    out += plots(grid_study) + folded_html(grid_study_checks(grid_study));
    for (const ReportTable& table : grid_study_details(grid_study)) out += folded_html(table);
    return out;
}

std::string grid_study_csv(const GridStudy& grid_study, std::size_t side) {
    const std::vector<GridStudyRun>& runs = grid_study.sides.at(side).runs;
    ReportTable table{"", {numbers("near_hull", "m")}};
    for (const GridStudyRun& run : runs) table.rows.push_back({{run.spacing}});
    for (const GridStudyQuantity& q : grid_study.quantities) {
        const std::vector<StudyLevel>& levels = q.values[side].levels;
        if (levels.size() != runs.size()) continue;
        table.columns.push_back(numbers(q.name, q.unit));
        for (std::size_t i = 0; i < levels.size(); ++i) table.rows[i].cells.emplace_back(levels[i].value);
    }
    return csv_of(table);
}

}  // namespace tw
