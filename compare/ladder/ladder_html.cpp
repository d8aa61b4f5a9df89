#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ladder/ladder_tables.h"
#include "compare/report/escape.h"
#include "compare/report/plot_data.h"
#include "methods/methods.h"

namespace tw {

namespace {

/// Values over spacing with their intervals, and where the fit points at spacing 0.
LivePlot convergence_plot(const Ladder& ladder, const LadderQuantity& q) {
    Plot plot;
    plot.title = q.label;
    plot.x_label = "spacing at the hull [m]";
    plot.y_label = q.unit;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        PlotLine line{method_label(ladder.sides[k].method), k, {}, {}, false, false, true};
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
    return live_plot(plot);
}

/// The uncertainty of each level over its wall time, with the fitted line drawn on to 1 % of the value.
LivePlot cost_plot(const Ladder& ladder, const LadderQuantity& q) {
    Plot plot;
    plot.title = q.label + ": what accuracy costs";
    plot.x_label = "wall time [s]";
    plot.y_label = "U [" + q.unit + "]";
    plot.log_x = plot.log_y = true;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        PlotLine line{method_label(ladder.sides[k].method), k, {}, {}, false, false, true};
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
    return live_plot(plot);
}

std::string plots(const Ladder& ladder) {
    std::string out;
    for (const LadderQuantity& q : ladder.quantities)
        if (std::ranges::any_of(q.values, [](const LadderValue& v) { return v.levels.size() > 2; })) {
            out += figure_html(convergence_plot(ladder, q));
            if (const LivePlot cost = cost_plot(ladder, q); !cost.svg.empty()) out += figure_html(cost);
        }
    return out.empty() ? out
                       : "<h2>Convergence, and accuracy over time</h2><div class=\"pair\">" + out +
                             "</div><p class=\"note\">Over the spacing: bars are the 95 % interval of the finest "
                             "value, broken lines lead "
                             "to the estimate for spacing 0. Over the wall time its run took, everything counted: the "
                             "interval of "
                             "every size (discretisation and statistics); broken: the fitted line.</p>";
}

}  // namespace

std::string ladder_html(const Ladder& ladder) {
    std::string out = html_of(ladder_held(ladder));
    if (out.empty())
        for (const std::string& line : ladder.calibrated)
            out += "<p class=\"note\">Tuned, not validated: " + escaped(line) + "</p>";
    out += plots(ladder);
    for (const ReportTable& table : {ladder_checks(ladder), ladder_shares(ladder), ladder_values(ladder),
                                     ladder_variations(ladder), ladder_prices(ladder), ladder_runs(ladder)})
        out += folded_html(table);
    return out;
}

}  // namespace tw
