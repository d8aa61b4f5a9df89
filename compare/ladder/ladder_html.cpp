#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ladder/ladder.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/svg_plot.h"

namespace tw {

namespace {

std::string method_cell(const Ladder& ladder, std::size_t k) {
    return fmt::format("<span class=\"key k{}\"></span>{}", k, escaped(ladder.sides[k].method));
}

bool has_levels(const LadderQuantity& q) {
    return std::ranges::any_of(q.values, [](const LadderValue& v) { return !v.levels.empty(); });
}

std::string verdict_table(const Ladder& ladder) {
    std::string out = "<div class=\"wide\"><table><thead><tr><th>Quantity</th>";
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        out += "<th class=\"num\">" + method_cell(ladder, k) + "</th>";
    out += "<th class=\"num\">difference</th><th class=\"num\">relative</th><th>verdict</th></tr></thead><tbody>";
    for (const LadderQuantity& q : ladder.quantities) {
        if (!has_levels(q)) continue;
        out += fmt::format("<tr{}><td>{} <span class=\"note\">[{}]</span></td>",
                           q.reason.empty() ? "" : " class=\"has-remark\"", escaped(q.label), escaped(q.unit));
        for (const LadderValue& v : q.values)
            out += "<td class=\"num\">" +
                   (v.levels.empty() ? std::string("–") : value_text(v.levels.front().value, v.uncertainty)) + "</td>";
        out += fmt::format(
            "<td class=\"num\">{}</td><td class=\"num\">{}</td><td><span class=\"badge {}\">{}</span></td></tr>",
            signed_text(q.difference, q.interval), per_cent_text(q.per_cent), to_string(q.verdict),
            verdict_label(q.verdict));
        if (!q.reason.empty())
            out += fmt::format("<tr class=\"remark\"><td colspan=\"{}\">{}</td></tr>", 4 + ladder.sides.size(),
                               escaped(q.reason));
    }
    return out + "</tbody></table></div>";
}

/// Values over spacing with their intervals, and where the fit points at spacing 0.
std::string convergence_plot(const Ladder& ladder, const LadderQuantity& q) {
    Plot plot;
    plot.title = q.label;
    plot.x_label = "spacing at the hull [m]";
    plot.y_label = q.unit;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        PlotLine line{ladder.sides[k].method, k, {}, {}, false, false, true};
        for (const Level& l : v.levels) line.x.push_back(l.spacing), line.y.push_back(l.value);
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
std::string cost_plot(const Ladder& ladder, const LadderQuantity& q) {
    Plot plot;
    plot.title = q.label + ": what accuracy costs";
    plot.x_label = "wall time [s]";
    plot.y_label = "U [" + q.unit + "]";
    plot.log_x = plot.log_y = true;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        PlotLine line{ladder.sides[k].method, k, {}, {}, false, false, true};
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

std::string plots(const Ladder& ladder) {
    std::string out;
    for (const LadderQuantity& q : ladder.quantities)
        if (std::ranges::any_of(q.values, [](const LadderValue& v) { return v.levels.size() > 2; })) {
            out += "<figure>" + convergence_plot(ladder, q) + "</figure>";
            if (const std::string cost = cost_plot(ladder, q); !cost.empty()) out += "<figure>" + cost + "</figure>";
        }
    return out.empty() ? out
                       : "<h2>Convergence, and what accuracy costs</h2><div class=\"pair\">" + out +
                             "</div><p class=\"note\">Over the spacing: bars are the 95 % interval of the finest "
                             "value, broken lines lead "
                             "to the estimate for spacing 0. Over the wall time its run took, everything counted: the "
                             "interval of "
                             "every level (resolution and statistics); broken: the fitted line.</p>";
}

std::string price_table(const Ladder& ladder) {
    std::string rows;
    for (const LadderQuantity& q : ladder.quantities) {
        if (!has_levels(q)) continue;
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const LadderValue& v = q.values[k];
            rows += "<tr><td>" + (k == 0 ? escaped(q.label) : std::string()) + "</td><td>" + method_cell(ladder, k) +
                    "</td>";
            if (!v.cost.known() || v.levels.empty()) {
                rows += "<td colspan=\"7\" class=\"note\">" + escaped(v.cost.why_not) + "</td></tr>";
                continue;
            }
            rows += fmt::format("<td class=\"num\">{:.2f}</td>", v.cost.slope);
            for (const double share : {0.05, 0.02, 0.01}) {
                const double seconds = v.cost.seconds_for(share * q.size);
                rows += fmt::format("<td class=\"num\">{}{}</td>", v.cost.measured(seconds) ? "" : "~ ",
                                    time_text(seconds));
            }
            rows +=
                fmt::format("<td class=\"num\">× {:.3g}</td><td class=\"num\">{}</td><td class=\"num\">{}</td></tr>",
                            v.cost.price_of_halving(), cores_text(v.cost_in_cores, 0.02 * q.size),
                            memory_text(v.cost_in_memory, 0.02 * q.size));
        }
        if (const std::string crossover = crossover_sentence(ladder, q); !crossover.empty())
            rows += "<tr class=\"remark\"><td></td><td colspan=\"8\">" + escaped(crossover) + "</td></tr>";
    }
    return "<h2>The price of a digit</h2><div class=\"wide\"><table><thead><tr><th>Quantity</th><th>method</th><th "
           "class=\"num\">slope of U over time</th><th class=\"num\">time to 5 %</th><th class=\"num\">to 2 %</th><th "
           "class=\"num\">to 1 %</th><th class=\"num\">halving U costs</th><th class=\"num\">core hours to 2 %</th><th "
           "class=\"num\">memory to 2 %</th></tr></thead><tbody>" +
           rows + "</tbody></table></div><p class=\"note\">~: beyond the times of this ladder, by its slope.</p>";
}

std::string run_rows(const std::string& method, const LadderRun& r) {
    return fmt::format(
        "<tr><td>{}</td><td class=\"num\">{:g}</td><td class=\"num\">{:.4g}</td><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td><td class=\"num\">{:.3g}</td><td class=\"num\">{:.4g}</td></tr>",
        method, r.spacing, r.elements, time_text(r.seconds),
        r.predicted_seconds > 0 ? time_text(r.predicted_seconds) : "–", r.core_seconds / 3600, r.memory / 1e6);
}

std::string runs_table(const Ladder& ladder) {
    std::string out =
        "<h2>The runs of the ladder</h2><div class=\"wide\"><table><thead><tr><th>method</th><th "
        "class=\"num\">spacing [m]</th><th class=\"num\">particles or cells</th><th class=\"num\">wall time</th><th "
        "class=\"num\">predicted</th><th class=\"num\">core hours</th><th class=\"num\">memory "
        "[MB]</th></tr></thead><tbody>";
    for (std::size_t k = 0; k < ladder.sides.size(); ++k) {
        for (const LadderRun& r : ladder.sides[k].runs) out += run_rows(method_cell(ladder, k), r);
        for (const LadderVariation& v : ladder.sides[k].variations)
            out += run_rows(method_cell(ladder, k) + ", " + escaped(v.name), v.run);
    }
    return out + "</tbody></table></div>";
}

/// Every share of each interval, in per cent of the value.
std::string shares_table(const Ladder& ladder) {
    std::string rows;
    for (const LadderQuantity& q : ladder.quantities)
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const LadderValue& v = q.values[k];
            if (v.levels.empty()) continue;
            const auto share = [&](double U) {
                return std::isfinite(U) && q.size > 0 ? fmt::format("{:.2g} %", 100 * U / q.size) : std::string("–");
            };
            std::string choices;
            for (const Sensitivity& s : v.sensitivities)
                choices +=
                    (choices.empty() ? "" : "; ") + s.name + ": " + (s.idle() ? "no change" : share(s.uncertainty));
            rows += fmt::format(
                "<tr><td>{}</td><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
                "class=\"num\">{}</td><td class=\"num\">{}</td><td>{}</td><td>{}</td></tr>",
                k == 0 ? escaped(q.label) : "", method_cell(ladder, k), share(v.statistical),
                share(v.estimate.uncertainty), share(v.estimate.celik_gci.uncertainty),
                share(v.estimate.xing_stern.uncertainty), escaped(verdict_sentence(v.estimate)), escaped(choices));
        }
    return "<details open><summary>What the intervals are made of</summary><div class=\"wide\"><table><thead><tr><th>"
           "Quantity</th><th>method</th><th class=\"num\">mean</th><th class=\"num\">resolution</th><th "
           "class=\"num\">GCI</th><th "
           "class=\"num\">factor of safety</th><th>what the resolution says</th><th>choices</th></tr></thead><tbody>" +
           rows + "</tbody></table></div></details>";
}

/// Each method's finest values beside what was measured, or a formula says.
std::string held_table(const Ladder& ladder) {
    std::string rows;
    for (const LadderQuantity& q : ladder.quantities)
        for (const Held& h : q.held)
            for (std::size_t k = 0; k < h.validations.size(); ++k) {
                const Validation& v = h.validations[k];
                rows += fmt::format(
                    "<tr><td>{}</td><td>{}</td><td class=\"num\">{}</td><td>{}</td><td class=\"num\">{}</td><td "
                    "class=\"num\">{}</td><td class=\"num\">{}</td><td><span class=\"badge {}\">{}</span></td></tr>",
                    k == 0 ? escaped(q.label + " [" + q.unit + "]") : "", k == 0 ? escaped(h.source) : "",
                    k == 0 ? mean_text(h.value) : "", method_cell(ladder, k), signed_text(v.E, v.U_val),
                    per_cent_text(v.per_cent), std::isfinite(v.U_val) ? value_text(v.U_val, 0) : "–",
                    to_string(v.verdict), validation_label(v));
            }
    std::string out;
    if (!rows.empty())
        out =
            "<h2>Against what was measured, or a formula says</h2><div "
            "class=\"wide\"><table><thead><tr><th>Quantity</th>"
            "<th>source</th><th class=\"num\">its value</th><th>method</th><th class=\"num\">value − its</th><th "
            "class=\"num\">relative</th><th class=\"num\">U</th><th>within</th></tr></thead><tbody>" +
            rows +
            "</tbody></table></div><p class=\"note\">U holds the interval of the finest value and, where one is known, "
            "that of the other value (ASME V&amp;V 20). These values take no part in the verdict between the "
            "methods.</p>";
    for (const std::string& line : ladder.calibrated)
        out += "<p class=\"note\">Calibrated, not validated: " + escaped(line) + "</p>";
    return out;
}

}  // namespace

std::string ladder_html(const Ladder& ladder) {
    std::string out;
    for (const LadderQuantity& q : ladder.quantities)
        if (q.name == "lift" || q.name == "drag" || q.name == "splash_sheet_height") {
            if (has_levels(q)) out += (out.empty() ? "" : "<br>") + escaped(ladder_sentence(q));
        }
    if (!out.empty()) out = "<div class=\"verdict\">" + out + "</div>";
    for (const LadderSide& side : ladder.sides)
        if (!side.similar)
            out += "<div class=\"banner\">The " + escaped(side.method) +
                   " runs differ in more than their resolution: they are no family.</div>";
    for (const std::string& line : ladder.left_out) out += "<div class=\"banner\">" + escaped(line) + "</div>";
    out += "<h2>Verdict of the ladder</h2>" + verdict_table(ladder) +
           fmt::format(
               "<p class=\"note\">Finest values with 95 % intervals that hold the statistics of the mean, the error of "
               "the resolution (least squares of Eça and Hoekstra from four levels on) and the runs with other "
               "choices. Agree: the difference lies inside the joint interval, and that is at most {:g} % of the "
               "value.</p>",
               100 * ladder.agree_within) +
           held_table(ladder) + shares_table(ladder) + plots(ladder) + price_table(ladder) + runs_table(ladder);
    return out + "<h2>The finest pair</h2>";
}

}  // namespace tw
