#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "compare/sweep/sweep.h"

namespace tw {

namespace {

std::string summary_table(const Sweep& sweep) {
    std::string rows;
    for (const SweepSummary& s : sweep.summaries) {
        rows += fmt::format(
            "<tr><td>{} <span class=\"note\">[{}]</span></td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
            "class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td></tr>",
            escaped(s.label), escaped(s.unit), s.points.size(), ratio_text(s.bias),
            std::isfinite(s.interval) ? ratio_text(s.bias - s.interval) + " … " + ratio_text(s.bias + s.interval) : "–",
            std::isfinite(s.scatter) ? fmt::format("× {:.3g}", std::exp(s.scatter)) : "–", s.left_out);
    }
    return fmt::format(
               "<div class=\"wide\"><table><thead><tr><th>Quantity</th><th class=\"num\">scenes</th><th "
               "class=\"num\">bias, {} over {}</th><th class=\"num\">its 95 % interval</th><th "
               "class=\"num\">scatter</th><th class=\"num\">left out</th></tr></thead><tbody>",
               escaped(sweep.methods[1]), escaped(sweep.methods[0])) +
           rows +
           "</tbody></table></div><p class=\"note\">Bias: mean of the logarithm of the ratio, as a percentage. "
           "Scatter: "
           "factor of its standard deviation. Left out: a value is missing or 0, or the signs differ.</p>";
}

/// Values of the second method over those of the first, each with its intervals; the line of equal values.
std::string scatter_plot(const Sweep& sweep, const SweepSummary& s) {
    Plot plot;
    plot.title = s.label;
    plot.x_label = sweep.methods[0] + " [" + s.unit + "]";
    plot.y_label = sweep.methods[1] + " [" + s.unit + "]";
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

std::string member_table(const Sweep& sweep, const SweepSummary& s) {
    std::string rows;
    for (const auto& p : s.points)
        rows += fmt::format(
            "<tr><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td><span "
            "class=\"badge {}\">{}</span></td></tr>",
            escaped(sweep.members[p.member].name), value_text(p.a, p.Ua), value_text(p.b, p.Ub),
            per_cent_text(100 * (p.b / p.a - 1)), to_string(p.verdict), verdict_label(p.verdict));
    return fmt::format(
               "<div class=\"wide\"><table><thead><tr><th>{} [{}]</th><th class=\"num\">{}</th><th "
               "class=\"num\">{}</th><th class=\"num\">relative</th><th>verdict</th></tr></thead><tbody>",
               escaped(s.label), escaped(s.unit), escaped(sweep.methods[0]), escaped(sweep.methods[1])) +
           rows + "</tbody></table></div>";
}

std::string members_list(const Sweep& sweep) {
    std::string out = "<h2>The scenes</h2><ul>";
    for (const SweepMember& m : sweep.members)
        out += "<li>" + escaped(m.name) +
               (m.why_not.empty() ? ": <a href=\"" + escaped(m.report) + "\">report</a>"
                                  : ": <strong>no comparison</strong>: " + escaped(m.why_not)) +
               "</li>";
    return out + "</ul>";
}

}  // namespace

std::string sweep_html(const Sweep& sweep) {
    const auto good = std::ranges::count_if(sweep.members, [](const SweepMember& m) { return m.why_not.empty(); });
    std::string out = page_begin(sweep.title) + "<h1>" + escaped(sweep.title) + "</h1><p class=\"sub\">" +
                      fmt::format("{} scenes, {} compared</p>", sweep.members.size(), good);
    if (sweep.methods.size() == 2) {
        out += "<h2>Bias and scatter between the methods</h2>" + summary_table(sweep);
        std::string plots, tables;
        for (const SweepSummary& s : sweep.summaries)
            if (!s.points.empty()) plots += scatter_plot(sweep, s), tables += member_table(sweep, s);
        out += "<div class=\"pair\">" + plots + "</div><h2>Scene by scene</h2>" + tables;
    }
    return out + members_list(sweep) + page_end;
}

}  // namespace tw
