#include "compare/truth/validation_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "methods/methods.h"

namespace tw {
namespace {

/// Values over truths, one place along x for each, with the bars of U_val about them and the truth's own band.
std::string plot_against_truth(const ValidationReport& report, const std::string& family) {
    Plot plot;
    plot.title = family, plot.y_label = "value over truth", plot.x_label = "quantity, in the order of the tables";
    plot.levels.push_back({"truth", 1});
    std::vector<PlotLine> dots;
    double place = 0;
    for (const ValidatedCase& c : report.cases)
        for (const ValidatedQuantity& q : c.quantities) {
            if (c.family != family || q.truth.value == 0) continue;
            ++place;
            for (const ValidatedValue& v : q.values) {
                if (!std::isfinite(v.value)) continue;
                const std::size_t source = method_rank(v.method);
                const double x = place + 0.12 * (static_cast<double>(source) - 0.5), y = v.value / q.truth.value,
                             bar = v.U_val / std::abs(q.truth.value);
                if (std::isfinite(bar)) plot.lines.push_back({"", source, {x, x}, {y - bar, y + bar}});
                auto at = std::ranges::find(dots, source, &PlotLine::source);
                if (at == dots.end())
                    at = dots.insert(dots.end(), {method_label(v.method), source, {}, {}, false, false, true});
                if (!at->x.empty()) at->x.push_back(at->x.back()), at->y.push_back(nan);  // no line between dots
                at->x.push_back(x), at->y.push_back(y);
            }
        }
    if (dots.empty()) return {};
    for (PlotLine& d : dots) plot.lines.push_back(std::move(d));
    return "<figure>" + svg(plot) + "</figure>";
}

std::vector<std::string> families_of(const ValidationReport& report) {
    std::vector<std::string> families;
    for (const ValidatedCase& c : report.cases)
        if (std::ranges::find(families, c.family) == families.end()) families.push_back(c.family);
    return families;
}

std::string facts_of(const ValidationReport& r) {
    return fmt::format("twinwake {}, {}, {}; tier {}; {}{}", r.version, r.machine, r.date, r.tier, r.command,
                       r.estimator.empty() ? "" : "; discretisation error by " + uncertainty_method_label(r.estimator));
}

/// "missed: 3.1 ± 0.2 Pa where 3.5 ± 0 Pa is true, goal 0.1".
std::string in_words(const ValidatedValue& v, const ValidatedQuantity& q) {
    return fmt::format("{}: {} {} where {} is true, goal {}{}", outcome_label(v.outcome), value_text(v.value, v.U_val),
                       q.unit, value_text(q.truth.value, q.truth.half_width), value_text(q.goal, 0),
                       v.kept ? fmt::format("; not run anew, kept of {}, {}", v.version, v.date) : "");
}

}  // namespace

std::string validation_text(const ValidationReport& report, const std::vector<ValidationChange>& changes) {
    std::vector<ReportTable> tables{validation_table(report), family_table(report), estimators_table(report)};
    if (!changes.empty()) tables.push_back(change_table(changes, {}));
    return fmt::format("# {}\n", for_terminal(report.title)) + text_of(tables);
}

std::string validation_html(const ValidationReport& report, const std::vector<ValidationChange>& changes,
                            const std::string& since) {
    std::string page = page_begin_with(report.title, facts_of(report));
    if (!since.empty()) {
        page += html_of(change_table(changes, since));
        if (changes.empty()) page += "<p>Nothing changed since " + escaped(since) + ".</p>";
    }
    page += html_of(std::vector{family_table(report), estimators_table(report)});
    page += "<h2>Values against truths</h2><div class=\"pair\">";
    for (const std::string& family : families_of(report)) page += plot_against_truth(report, family);
    page += "</div>" + html_of(validation_table(report));
    for (const ValidatedCase& c : report.cases) {
        page += "<h2>" + escaped(c.title) + "</h2><p>" + escaped(c.why) + "</p>";
        page += "<p class=\"note\">" +
                escaped(fmt::format("{}; tier {}; {}", c.family, c.tier, fmt::join(c.scenes, ", "))) + "</p>";
        if (!c.why_not.empty()) page += "<p><b>" + escaped(c.why_not) + "</b></p>";
        page += html_of(std::vector{parts_table(c), cost_table(c)}, 3);
    }
    return page + page_end;
}

std::string validation_csv(const ValidationReport& report) {
    ReportTable table{"", {words("case"),          words("family"),
                           words("tier"),          words("quantity"),
                           words("unit"),          words("method"),
                           numbers("truth"),       numbers("U_D"),
                           words("standing"),      numbers("value"),
                           numbers("U_num"),       numbers("U_input"),
                           numbers("U_val"),       numbers("E"),
                           numbers("goal"),        numbers("order"),
                           numbers("outer_below"), numbers("outer_above"),
                           words("outcome"),       words("reason"),
                           numbers("U_scatter"),   numbers("U_discretisation"),
                           numbers("U_box")}};
    for (const std::string& estimator : uncertainty_methods()) table.columns.push_back(numbers("U_" + estimator));
    for (const char* name : {"version", "date", "kept"}) table.columns.push_back(words(name));
    for (const ValidatedCase& c : report.cases)
        for (const ValidatedQuantity& q : c.quantities)
            for (const ValidatedValue& v : q.values) {
                ReportRow row{{c.name,
                               c.family,
                               c.tier,
                               q.name,
                               q.unit,
                               v.method,
                               q.truth.value,
                               q.truth.half_width,
                               q.truth.standing,
                               v.value,
                               v.U_num,
                               v.input,
                               v.U_val,
                               v.E,
                               q.goal,
                               v.order,
                               v.outer_below,
                               v.outer_above,
                               to_string(v.outcome),
                               v.why_not,
                               v.statistical,
                               v.discretisation,
                               v.choices}};
                for (const std::string& estimator : uncertainty_methods()) {
                    const auto by = std::ranges::find(v.by_method, estimator, &MethodEstimate::method);
                    row.cells.emplace_back(by == v.by_method.end() ? nan : by->uncertainty);
                }
                for (const std::string& text : {v.version, v.date, std::string(v.kept ? "kept" : "")})
                    row.cells.emplace_back(text);
                table.rows.push_back(std::move(row));
            }
    return csv_of(table);
}

std::string validation_junit(const ValidationReport& report) {
    std::string suites;
    int all = 0, all_failures = 0, all_errors = 0, all_skipped = 0;
    for (const ValidatedCase& c : report.cases) {
        std::string tests;
        int count = 0, failures = 0, errors = 0, skipped = 0;
        const auto child = [](const char* tag, const std::string& message) {
            return fmt::format("<{} message=\"{}\"/>", tag, escaped(message));
        };
        for (const ValidatedQuantity& q : c.quantities)
            for (const ValidatedValue& v : q.values) {
                std::string inside;
                const auto known = q.known_miss.find(v.method);
                if (v.outcome == Outcome::not_run)
                    inside = child("skipped", c.why_not.empty() ? v.why_not : c.why_not), ++skipped;
                else if (v.outcome == Outcome::failed)
                    inside = child("error", v.why_not), ++errors;
                else if (falls_short(v, q) && known != q.known_miss.end())
                    inside = child("skipped", "known: " + known->second + "; " + in_words(v, q)), ++skipped;
                else if (falls_short(v, q))
                    inside = child("failure", in_words(v, q)), ++failures;
                else
                    inside = "<system-out>" + escaped(in_words(v, q)) + "</system-out>";
                double seconds = 0;
                for (const CaseCost& cost : c.costs)
                    if (cost.method == v.method) seconds = cost.seconds;
                tests += fmt::format("<testcase classname=\"{}\" name=\"{} {}\" time=\"{:.3f}\">{}</testcase>\n",
                                     escaped(c.name), escaped(q.name), escaped(v.method), seconds, inside);
                ++count;
            }
        suites += fmt::format(
            "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}</testsuite>\n",
            escaped(c.name), count, failures, errors, skipped, tests);
        all += count, all_failures += failures, all_errors += errors, all_skipped += skipped;
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" "
        "errors=\"{}\" skipped=\"{}\">\n{}</testsuites>\n",
        escaped(report.title), all, all_failures, all_errors, all_skipped, suites);
}

}  // namespace tw
