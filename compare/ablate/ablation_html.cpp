#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ablate/ablation.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"

namespace tw {

namespace {

using Seen = AblationChange::Seen;

const AblationChange* find(const AblationRow& row, const std::string& name) {
    const auto c = std::ranges::find(row.changes, name, &AblationChange::name);
    return c == row.changes.end() ? nullptr : &*c;
}

const AblationChange* any(const AblationMethod& method, const std::string& name) {
    for (const AblationRow& row : method.rows)
        if (const AblationChange* c = find(row, name)) return c;
    return nullptr;
}

/// The report's colours: what was seen stands out, what was not stays pale.
const char* badge_of(Seen seen) {
    switch (seen) {
        case Seen::seen: return "differ";
        case Seen::nothing:
        case Seen::unchanged: return "agree";
        case Seen::no_interval: return "undecided";
        case Seen::not_known: break;
    }
    return "not_comparable";
}

std::string overview(const Ablation& ablation, const AblationMethod& method) {
    const std::vector<std::string> names = headline_of(method);
    std::string out = "<div class=\"wide\"><table><thead><tr><th>Switched</th><th>against</th>";
    for (const std::string& name : names) out += "<th class=\"num\">" + escaped(any(method, name)->label) + "</th>";
    out += "<th class=\"num\">processor time</th><th class=\"num\">the plan's</th></tr></thead><tbody>";
    for (const AblationRow& row : method.rows) {
        const AblationRun& run = ablation.runs[row.run];
        out += "<tr><td>" + escaped(run.name) + "</td><td>" + escaped(ablation.runs[run.against].name) + "</td>";
        for (const std::string& name : names) {
            const AblationChange* c = find(row, name);
            const std::string text = c ? escaped(change_text(*c)) : "–";
            out += "<td class=\"num\">" +
                   (c && c->seen == Seen::seen ? "<span class=\"badge differ\">" + text + "</span>" : text) + "</td>";
        }
        out += fmt::format("<td class=\"num\">{}</td><td class=\"num\">{}</td></tr>", per_cent_text(row.cost),
                           per_cent_text(row.predicted_cost));
    }
    return out + "</tbody></table></div>";
}

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
            if (const AblationChange* c = find(row, name); c && std::isfinite(c->per_cent))
                bars.push_back(
                    {brief(ablation.runs[row.run].name), c->per_cent, c->per_cent_interval, c->seen == Seen::seen});
        if (!bars.empty()) out += bars_svg(any(method, name)->label, bars);
    }
    std::vector<Bar> costs;
    for (const AblationRow& row : method.rows)
        if (std::isfinite(row.cost))
            costs.push_back({brief(ablation.runs[row.run].name), row.cost, std::nan(""), false});
    if (!costs.empty()) out += bars_svg("Processor time", costs);
    return "<div class=\"pair\">" + out + "</div>";
}

std::string details(const Ablation& ablation, const AblationRow& row) {
    const AblationRun& run = ablation.runs[row.run];
    std::string out = "<h3>" + escaped(run.name) + ", against " + escaped(ablation.runs[run.against].name) + "</h3>";
    if (!row.influence.empty()) out += "<p class=\"note\">The plan: " + escaped(row.influence) + "</p>";
    out +=
        "<div class=\"wide\"><table><thead><tr><th>Quantity</th><th class=\"num\">before</th><th "
        "class=\"num\">after</th><th class=\"num\">change</th><th></th><th>the plan's "
        "estimate</th></tr></thead><tbody>";
    for (const AblationChange& c : row.changes) {
        out += fmt::format(
            "<tr><td>{} <span class=\"note\">[{}]</span></td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
            "class=\"num\">{}</td><td><span class=\"badge {}\">{}</span>{}</td><td>{}</td></tr>",
            escaped(c.label), escaped(c.unit), mean_text(c.before), mean_text(c.after), escaped(change_text(c)),
            badge_of(c.seen), to_string(c.seen),
            c.remark.empty() ? "" : " <span class=\"note\">" + escaped(c.remark) + "</span>", escaped(c.predicted));
    }
    out += fmt::format(
        "<tr><td>Processor seconds per simulated second</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td><td>{}</td><td>{}</td></tr>",
        value_text(row.processor_before, 0), value_text(row.processor_after, 0), per_cent_text(row.cost),
        std::isfinite(row.steps) ? "<span class=\"note\">time steps: " + per_cent_text(row.steps) + "</span>" : "",
        per_cent_text(row.predicted_cost));
    return out + "</tbody></table></div>";
}

}  // namespace

std::string ablation_html(const Ablation& ablation) {
    const std::string title = ablation.title + ": one effect switched at a time";
    const auto good = std::ranges::count_if(ablation.runs, [](const AblationRun& r) { return r.why_not.empty(); });
    std::string out = page_begin(title) + "<h1>" + escaped(title) + "</h1><p class=\"sub\">" +
                      fmt::format("{} effects switched, each in a run of its own; {} without a result</p>", good - 1,
                                  static_cast<std::ptrdiff_t>(ablation.runs.size()) - good);
    for (const AblationMethod& method : ablation.methods) {
        if (method.rows.empty()) continue;
        out += "<h2>" + escaped(method.method) + "</h2>" + overview(ablation, method) + charts(ablation, method);
    }
    out +=
        "<p class=\"note\">Changes in per cent of the value before, with the 95 % intervals of both runs combined; the "
        "error of the resolution is not in them. A change beyond its interval is marked; chance alone does that once "
        "in twenty times. Processor time: of solving, per simulated second, of one run each; a busy machine changes "
        "it by several per cent.</p>";
    std::string failed;
    for (const AblationRun& run : ablation.runs)
        if (!run.why_not.empty())
            failed += "<li>" + escaped(run.name) + ": <strong>no result</strong>: " + escaped(run.why_not) + "</li>";
    if (!failed.empty()) out += "<h2>Without a result</h2><ul>" + failed + "</ul>";
    for (const AblationMethod& method : ablation.methods) {
        if (method.rows.empty()) continue;
        out += "<h2>Effect by effect: " + escaped(method.method) + "</h2>";
        for (const AblationRow& row : method.rows) out += details(ablation, row);
    }
    return out + page_end;
}

}  // namespace tw
