#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ablate/ablation_tables.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "methods/methods.h"

namespace tw {

namespace {

/// One line of a chart of changes.
struct Bar {
    std::string name;
    double value, half_width;  ///< [%]; half width NaN: none
    bool seen;
};

/// Changes in per cent with their intervals, one below the other, about the line of no change.
std::string bars_svg(const std::string& title, const std::vector<Bar>& bars) {
    constexpr double left = 190, width = 460, right = 14, top = 26, line = 22;
    double low = 0, high = 0;
    for (const Bar& b : bars) {
        const double u = std::isfinite(b.half_width) ? b.half_width : 0;
        low = std::min(low, b.value - u), high = std::max(high, b.value + u);
    }
    if (!(high > low)) high = 1, low = -1;
    const double margin = 0.06 * (high - low);
    low -= margin, high += margin;
    const double bottom = top + line * static_cast<double>(bars.size());
    const auto x = [&](double v) { return left + (v - low) / (high - low) * (width - left - right); };
    std::string out = fmt::format(
        "<figure><svg class=\"plot\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\"><text class=\"plot-title\" x=\"4\" "
        "y=\"15\">{}</text>",
        width, bottom + 24, escaped(title));
    for (const double t : ticks(low, high, 4))
        if (t >= low && t <= high)
            out += fmt::format(
                "<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/><text class=\"tick "
                "mid\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4:g} %</text>",
                x(t), top, bottom, bottom + 16, t == 0 ? 0.0 : t);
    out +=
        fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" style=\"stroke:var(--soft)\"/>",
                    x(0), top, bottom);
    double y = top + 0.5 * line;
    for (const Bar& b : bars) {
        const char* colour = b.seen ? "var(--s1)" : "var(--s0)";
        out += fmt::format("<text x=\"4\" y=\"{:.1f}\">{}</text>", y + 4, escaped(b.name));
        if (std::isfinite(b.half_width))
            out += fmt::format(
                "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" style=\"stroke:{};stroke-width:2\"/>",
                x(b.value - b.half_width), y, x(b.value + b.half_width), y, colour);
        out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" style=\"fill:{}\"/>", x(b.value), y, colour);
        y += line;
    }
    return out + "</svg></figure>";
}

/// "viscosity on" of "viscosity on (with no_slip)": what fits beside a chart.
std::string brief(const std::string& name) { return name.substr(0, name.find(" (")); }

std::string charts(const Ablation& ablation, const AblationMethod& method) {
    std::string out;
    for (const std::string& name : headline_of(method)) {
        std::vector<Bar> bars;
        for (const AblationRow& row : method.rows)
            if (const AblationChange* c = change_in(row, name); c && std::isfinite(c->per_cent))
                bars.push_back({brief(ablation.runs[row.run].name), c->per_cent, c->per_cent_interval,
                                c->seen == AblationChange::Seen::seen});
        if (!bars.empty()) out += bars_svg(change_label(method, name), bars);
    }
    std::vector<Bar> costs;
    for (const AblationRow& row : method.rows)
        if (std::isfinite(row.cost))
            costs.push_back({brief(ablation.runs[row.run].name), row.cost, std::nan(""), false});
    if (!costs.empty()) out += bars_svg("Processor time", costs);
    return "<div class=\"pair\">" + out + "</div>";
}

}  // namespace

std::string ablation_html(const Ablation& ablation) {
    const std::string title = ablation.title + ": one effect switched at a time";
    const auto good = std::ranges::count_if(ablation.runs, [](const AblationRun& r) { return r.why_not.empty(); });
    std::string out = page_begin(title) + "<h1>" + escaped(title) + "</h1><p class=\"sub\">" +
                      fmt::format("{} effects switched, each in a run of its own; {} without a result</p>", good - 1,
                                  static_cast<std::ptrdiff_t>(ablation.runs.size()) - good);
    for (const AblationMethod& method : ablation.methods)
        if (!method.rows.empty()) out += html_of(ablation_overview(ablation, method)) + charts(ablation, method);
    out += std::string("<p class=\"note\">") + ablation_note + "</p>" + html_of(ablation_missing(ablation));
    for (const AblationMethod& method : ablation.methods) {
        if (method.rows.empty()) continue;
        out += "<h2>Effect by effect: " + escaped(method_label(method.method)) + "</h2>";
        for (const AblationRow& row : method.rows) out += html_of(ablation_details(ablation, row, method.method), 3);
    }
    return out + page_end;
}

}  // namespace tw
