#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "compare/sweep/sweep_tables.h"
#include "methods/methods.h"

namespace tw {

namespace {

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

}  // namespace

std::string sweep_html(const Sweep& sweep) {
    const auto good = std::ranges::count_if(sweep.members, [](const SweepMember& m) { return m.why_not.empty(); });
    std::string out = page_begin(sweep.title) + "<h1>" + escaped(sweep.title) + "</h1><p class=\"sub\">" +
                      fmt::format("{} scenes, {} compared</p>", sweep.members.size(), good);
    out += html_of(sweep_summaries(sweep));
    std::string plots, links;
    for (const SweepSummary& s : sweep.summaries)
        if (!s.points.empty()) plots += scatter_plot(sweep, s);
    if (!plots.empty()) out += "<div class=\"pair\">" + plots + "</div>";
    out += html_of(sweep_values(sweep));
    for (const SweepMember& m : sweep.members)
        if (m.why_not.empty())
            links += fmt::format("<li><a href=\"{}\">{}</a></li>", escaped(m.report), escaped(m.name));
    if (!links.empty()) links = "<p>Reports:</p><ul>" + links + "</ul>";
    return out + html_of(sweep_scenes(sweep)) + links + page_end;
}

}  // namespace tw
