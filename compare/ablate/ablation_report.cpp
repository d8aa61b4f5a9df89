#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ablate/ablation.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/report_table.h"
#include "compare/report/svg_plot.h"
#include "methods/methods.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;
using Seen = AblationChange::Seen;

/// What the numbers mean; stands below the overview.
constexpr const char* ablation_note =
    "Changes in per cent of the value before, with the 95 % intervals of both runs combined; the discretisation error "
    "is not in "
    "them. A change beyond its interval is marked; chance alone does that once in twenty times. Processor time: "
    "of solving, per simulated second, of one run each; a busy machine changes it by several per cent.";

/// What was seen stands out, what was not stays pale.
Mark mark_of(Seen seen) {
    switch (seen) {
        case Seen::seen: return Mark::bad;
        case Seen::nothing:
        case Seen::unchanged: return Mark::good;
        case Seen::no_interval: return Mark::open;
        case Seen::not_known: break;
    }
    return Mark::faint;
}

/// One quantity's change in a row; null: not there.
const AblationChange* change_in(const AblationRow& row, const std::string& name) {
    const auto c = std::ranges::find(row.changes, name, &AblationChange::name);
    return c == row.changes.end() ? nullptr : &*c;
}

/// A quantity's name for people.
std::string change_label(const AblationMethod& method, const std::string& name) {
    for (const AblationRow& row : method.rows)
        if (const AblationChange* c = change_in(row, name)) return c->label;
    return name;
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

/// Every effect against the quantities that matter most; the heading is the method.
ReportTable overview_of(const Ablation& ablation, const AblationMethod& method) {
    const std::vector<std::string> names = headline_of(method);
    ReportTable table{method_label(method.method), {words("Switched"), words("compared with")}};
    for (const std::string& name : names) table.columns.push_back(numbers(change_label(method, name)));
    table.columns.push_back(numbers("processor time"));
    table.columns.push_back(numbers("predicted"));
    for (const AblationRow& row : method.rows) {
        const AblationRun& run = ablation.runs[row.run];
        ReportRow line{{run.name, ablation.runs[run.against].name}};
        for (const std::string& name : names) {
            const AblationChange* c = change_in(row, name);
            line.cells.emplace_back(c ? change_text(*c) : "–", c && c->seen == Seen::seen ? Mark::bad : Mark::none);
        }
        line.cells.emplace_back(per_cent_text(row.cost));
        line.cells.emplace_back(per_cent_text(row.predicted_cost));
        table.rows.push_back(std::move(line));
    }
    table.picture = charts(ablation, method);
    return table;
}

/// One effect switched, with every quantity.
ReportTable details_of(const Ablation& ablation, const AblationRow& row, const std::string& method) {
    const AblationRun& run = ablation.runs[row.run];
    ReportTable table{
        fmt::format("{}: {}, compared with {}", method_label(method), run.name, ablation.runs[run.against].name),
        {words("Quantity"), words("unit"), numbers("before"), numbers("after"), numbers("change"), words(""),
         words("the plan's estimate")}};
    for (const AblationChange& c : row.changes)
        table.rows.push_back({{c.label, c.unit, mean_text(c.before), mean_text(c.after), change_text(c),
                               ReportCell(to_string(c.seen), mark_of(c.seen)), c.predicted},
                              c.remark});
    table.rows.push_back(
        {{"Processor time of solving", "s/s", value_text(row.processor_before, 0), value_text(row.processor_after, 0),
          per_cent_text(row.cost), std::isfinite(row.steps) ? "time steps: " + per_cent_text(row.steps) : "",
          per_cent_text(row.predicted_cost)}});
    if (!row.influence.empty()) table.notes.push_back("The plan: " + row.influence);
    return table;
}

/// What was not run or did not finish, and why.
ReportTable without_result(const Ablation& ablation) {
    ReportTable table{"Without a result", {words("Switched"), words("reason")}};
    for (const AblationRun& run : ablation.runs)
        if (!run.why_not.empty()) table.rows.push_back({{run.name, run.why_not}});
    return table;
}

/// What the page and the terminal say first: every effect against the main quantities, method by method.
std::vector<ReportTable> overviews_of(const Ablation& ablation) {
    std::vector<ReportTable> tables;
    for (const AblationMethod& method : ablation.methods)
        if (!method.rows.empty()) tables.push_back(overview_of(ablation, method));
    return tables;
}

/// And then, effect by effect.
std::vector<ReportTable> details_of(const Ablation& ablation, const AblationMethod& method) {
    std::vector<ReportTable> tables;
    for (const AblationRow& row : method.rows) tables.push_back(details_of(ablation, row, method.method));
    return tables;
}

}  // namespace

std::string change_text(const AblationChange& c) {
    if (c.seen == Seen::not_known) return "–";
    if (c.seen == Seen::unchanged) return "unchanged";
    if (!std::isfinite(c.per_cent)) return signed_text(c.difference, c.interval) + " " + c.unit;
    if (!std::isfinite(c.per_cent_interval)) return per_cent_text(c.per_cent);
    return signed_text(c.per_cent, c.per_cent_interval) + " %";
}

std::string ablation_summary(const Ablation& ablation) {
    return fmt::format("# {}: one effect switched at a time\n", for_terminal(ablation.title)) +
           text_of(overviews_of(ablation)) + "\n" + ablation_note + "\n" +
           text_of(std::vector<ReportTable>{without_result(ablation)});
}

std::string ablation_text(const Ablation& ablation) {
    std::string out = ablation_summary(ablation);
    for (const AblationMethod& method : ablation.methods) out += text_of(details_of(ablation, method));
    return out;
}

std::string ablation_html(const Ablation& ablation) {
    const std::string title = ablation.title + ": one effect switched at a time";
    const auto good = std::ranges::count_if(ablation.runs, [](const AblationRun& r) { return r.why_not.empty(); });
    const std::string facts = fmt::format("{} effects switched, each in a run of its own; {} without a result",
                                          good - 1, static_cast<std::ptrdiff_t>(ablation.runs.size()) - good);
    std::string out = page_begin_with(title, facts) + html_of(overviews_of(ablation)) + "<p class=\"note\">" +
                      ablation_note + "</p>" + html_of(without_result(ablation));
    for (const AblationMethod& method : ablation.methods)
        if (!method.rows.empty())
            out += "<h2>Effect by effect: " + escaped(method_label(method.method)) + "</h2>" +
                   html_of(details_of(ablation, method), 3);
    return out + page_end;
}

std::string ablation_json(const Ablation& ablation) {
    Json runs = Json::array(), changes = Json::array(), costs = Json::array();
    for (const AblationRun& r : ablation.runs)
        runs.push_back({{"name", r.name},
                        {"effect", r.effect},
                        {"against", ablation.runs[r.against].name},
                        {"why_not", r.why_not}});
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) {
            const std::string& name = ablation.runs[row.run].name;
            for (const AblationChange& c : row.changes)
                changes.push_back({{"run", name},
                                   {"method", method.method},
                                   {"quantity", c.name},
                                   {"unit", c.unit},
                                   {"before", c.before.value},
                                   {"before_interval", c.before.half_width},
                                   {"after", c.after.value},
                                   {"after_interval", c.after.half_width},
                                   {"difference", c.difference},
                                   {"interval", c.interval},
                                   {"per_cent", c.per_cent},
                                   {"per_cent_interval", c.per_cent_interval},
                                   {"seen", to_string(c.seen)},
                                   {"predicted", c.predicted},
                                   {"remark", c.remark}});
            costs.push_back({{"run", name},
                             {"method", method.method},
                             {"processor_seconds_per_second_before", row.processor_before},
                             {"processor_seconds_per_second_after", row.processor_after},
                             {"per_cent", row.cost},
                             {"predicted_per_cent", row.predicted_cost},
                             {"steps_per_cent", row.steps}});
        }
    const Json all = {{"title", ablation.title}, {"runs", runs}, {"changes", changes}, {"costs", costs}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string ablation_csv(const Ablation& ablation) {
    ReportTable table;
    for (const char* name : {"switched", "against", "method", "quantity", "unit", "before", "interval before", "after",
                             "interval after", "per cent", "interval per cent", "seen", "predicted"})
        table.columns.push_back(words(name));
    for (const AblationMethod& method : ablation.methods)
        for (const AblationRow& row : method.rows) {
            const AblationRun& run = ablation.runs[row.run];
            const std::string& against = ablation.runs[run.against].name;
            for (const AblationChange& c : row.changes)
                table.rows.push_back({{run.name, against, method.method, c.name, c.unit, c.before.value,
                                       c.before.half_width, c.after.value, c.after.half_width, c.per_cent,
                                       c.per_cent_interval, to_string(c.seen), c.predicted}});
            table.rows.push_back({{run.name, against, method.method, "cost", "s/s", row.processor_before, "",
                                   row.processor_after, "", row.cost, "", "", row.predicted_cost}});
        }
    return csv_of(table);
}

}  // namespace tw
