#include "compare/truth/validation_report.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw {
namespace {

ReportCell outcome_cell(Outcome outcome) {
    const auto mark = [&] {
        switch (outcome) {
            case Outcome::met:
            case Outcome::near: return Mark::good;
            case Outcome::missed:
            case Outcome::failed: return Mark::bad;
            case Outcome::undecided:
            case Outcome::not_converged: return Mark::open;
            case Outcome::not_run: return Mark::faint;
        }
        return Mark::none;
    };
    return {outcome_label(outcome), mark()};
}

/// In per cent of the quantity's scale, or in its unit where it has none.
std::string in_per_cent(const ValidatedQuantity& q, double size) {
    if (!std::isfinite(size)) return "–";
    return q.scale > 0 ? share_text(100 * size / q.scale) : value_text(size, 0) + " " + q.unit;
}

/// The commit of "0.1.0 (4bc74fc4)", or the version without one, and whether the value stood in an earlier report.
std::string run_with(const ValidatedValue& v) {
    if (v.version.empty()) return "–";
    std::string commits;
    for (std::size_t at = 0; at < v.version.size();) {
        const std::size_t end = std::min(v.version.find(", ", at), v.version.size());
        const std::string version = v.version.substr(at, end - at);
        const std::size_t open = version.find('('), close = version.rfind(')');
        const bool has_commit = open != std::string::npos && close != std::string::npos && open < close;
        commits +=
            (commits.empty() ? "" : " and ") + (has_commit ? version.substr(open + 1, close - open - 1) : version);
        at = end + 2;
    }
    return commits + (v.kept ? ", kept" : "");
}

std::string error_text(const ValidatedQuantity& q, const ValidatedValue& v) {
    return !std::isfinite(v.E) ? std::string("–")
           : q.scale > 0       ? per_cent_text(100 * v.E / q.scale)
                               : signed_text(v.E, v.U_val);
}

std::string quantity_text(const ValidatedQuantity& q) {
    return q.unit == "-" ? q.label : q.label + " [" + q.unit + "]";
}

/// Why there is no value or interval, or an odd one, or a miss that is known.
std::string own_remark(const ValidatedQuantity& q, const ValidatedValue& v) {
    if (v.convergence == small_changes)
        return v.why_not + "; U is three times the range of all sizes, which the goal allows";
    if (v.outcome == Outcome::failed || v.outcome == Outcome::not_converged) return v.why_not;
    const auto known = q.known_miss.find(v.method);
    return known != q.known_miss.end() && falls_short(v, q) ? "known: " + known->second : "";
}

/// That, and what is to be said of an earlier report's value.
std::string remark_of(const ValidatedQuantity& q, const ValidatedValue& v) {
    const std::string own = own_remark(q, v);
    return own + (own.empty() || v.kept_note.empty() ? "" : "; ") + v.kept_note;
}

constexpr const char* run_with_note =
    "Run with: the commit of the program that made the runs; kept: taken from an earlier report, not run with this "
    "one.";

void add_values(ReportTable& table, const ValidatedCase& c) {
    for (const ValidatedQuantity& q : c.quantities)
        for (const ValidatedValue& v : q.values) {
            ReportRow row{{c.name, q.label, q.unit, value_text(q.truth.value, q.truth.half_width)}};
            row.cells.push_back(run_cell(method_label(v.method), method_rank(v.method)));
            row.cells.emplace_back(value_text(v.value, v.U_num));
            row.cells.emplace_back(error_text(q, v));
            row.cells.emplace_back(in_per_cent(q, v.U_val));
            row.cells.emplace_back(in_per_cent(q, q.goal));
            row.cells.push_back(outcome_cell(v.outcome));
            row.cells.emplace_back(run_with(v), v.kept ? Mark::faint : Mark::none);
            row.remark = remark_of(q, v);
            table.rows.push_back(std::move(row));
        }
}

/// "82 ± 15: +15 ± 22 %, undecided".
ReportCell value_in_short(const ValidatedQuantity& q, const std::string& method) {
    const auto found = std::ranges::find(q.values, method, &ValidatedValue::method);
    if (found == q.values.end()) return {};
    const ValidatedValue& v = *found;
    const ReportCell outcome = outcome_cell(v.outcome);
    if (!std::isfinite(v.value)) return outcome;
    const std::string error = q.scale > 0 ? std::isfinite(v.U_val)
                                                ? per_cent_text(100 * v.E / q.scale, 100 * v.U_val / q.scale)
                                                : per_cent_text(100 * v.E / q.scale)
                                          : error_text(q, v);
    return {fmt::format("{}; {}: {}", value_text(v.value, v.U_num), error, outcome.text), outcome.mark};
}

std::vector<ReportColumn> short_columns(const std::vector<std::string>& methods) {
    std::vector<ReportColumn> columns{words("Quantity"), numbers("truth")};
    for (const std::string& method : methods) columns.push_back(words(method_label(method)));
    columns.push_back(numbers("goal"));
    return columns;
}

ReportRow short_row(const ValidatedQuantity& q, const std::vector<std::string>& methods) {
    ReportRow row{{quantity_text(q), value_text(q.truth.value, q.truth.half_width)}};
    for (const std::string& method : methods) row.cells.push_back(value_in_short(q, method));
    row.cells.emplace_back(in_per_cent(q, q.goal));
    for (const ValidatedValue& v : q.values)
        if (const std::string remark = remark_of(q, v); !remark.empty())
            row.remark += (row.remark.empty() ? "" : "; ") + method_label(v.method) + ": " + remark;
    return row;
}

constexpr const char* short_note =
    "Of each method: value; E ± U_val: verdict, as docs/validating.md defines them. Per cent are of the truth, or of "
    "what "
    "the suite says.";

std::string spacings_text(const ValidatedValue& v) {
    std::string sizes;
    for (const auto& [spacing, value] : v.sizes)
        sizes += fmt::format("{}{:.3g}", sizes.empty() ? "" : ", ", 1e3 * spacing);
    return sizes + " mm";
}

/// The sizes of every value of the case; empty where they are not the same.
std::string common_sizes(const ValidatedCase& one) {
    std::string all;
    for (const ValidatedQuantity& q : one.quantities)
        for (const ValidatedValue& v : q.values) {
            if (!std::isfinite(v.value)) continue;
            const std::string sizes = spacings_text(v);
            if (!all.empty() && sizes != all) return "";
            all = sizes;
        }
    return all;
}

std::string share(int some, int all) { return all == 0 ? "–" : fmt::format("{} of {}", some, all); }

}  // namespace

ReportTable validation_table(const ValidationReport& report) {
    ReportTable table{
        "Every value against its truth",
        {words("Case"), words("Quantity"), words("unit"), numbers("truth"), words("method"), numbers("value"),
         numbers("E"), numbers("U_val"), numbers("goal"), words("verdict"), words("run with")}};
    for (const ValidatedCase& c : report.cases) add_values(table, c);
    table.notes.push_back(
        "E: value less truth. U_val: half width of the 95 % interval of E, from discretisation, scatter, input and the "
        "truth's own uncertainty (ASME V&V 20). Per cent are of the truth, or of what the suite says.");
    table.notes.push_back(run_with_note);
    table.notes.push_back(
        "Met: abs(E) is below U_val and U_val below the goal. Undecided: U_val is above the goal. Within the goal, "
        "outside its interval: abs(E) is below the goal and above U_val. Missed: abs(E) is above both.");
    return table;
}

ReportTable short_table(const ValidationReport& report, const CaseName& name) {
    const std::vector<std::string> methods = methods_of(report);
    ReportTable table{"Every value against its truth", short_columns(methods)};
    table.columns.insert(table.columns.begin(), words("Case"));
    table.columns.push_back(words("run with"));
    for (const ValidatedCase& c : report.cases) {
        std::string shown = name(c);
        for (const ValidatedQuantity& q : c.quantities) {
            ReportRow row = short_row(q, methods);
            row.cells.insert(row.cells.begin(), std::exchange(shown, ""));
            std::string made;
            for (const ValidatedValue& v : q.values)
                if (const std::string with = run_with(v); with != "–" && made.find(with) == std::string::npos)
                    made += (made.empty() ? "" : "; ") + with;
            row.cells.emplace_back(made);
            row.remark.clear();  // stands on the page of the case
            table.rows.push_back(std::move(row));
        }
    }
    table.notes = {short_note, run_with_note};
    return table;
}

ReportTable short_table(const ValidatedCase& one) {
    ValidationReport alone;
    alone.cases = {one};
    const std::vector<std::string> methods = methods_of(alone);
    ReportTable table{"", short_columns(methods)};
    for (const ValidatedQuantity& q : one.quantities) table.rows.push_back(short_row(q, methods));
    return table;
}

ReportTable family_table(const ValidationReport& report) {
    ReportTable table{"How often the intervals contain the true value",
                      {words("Family"), words("method"), numbers("goal met"), numbers("falls short"),
                       numbers("interval holds"), numbers("outer holds"), numbers("narrow ones that hold"),
                       numbers("no interval"), numbers("median error"), numbers("processor time")}};
    for (const FamilySummary& f : summaries_of(report)) {
        const int all = f.values + f.without_interval;
        table.rows.push_back(
            {{f.family.empty() ? "all" : f.family, run_cell(method_label(f.method), method_rank(f.method)),
              share(f.met, all), share(f.fall_short, all), share(f.inner, f.values), share(f.outer, f.values),
              share(f.narrow_inner, f.narrow), f.without_interval,
              std::isfinite(f.median_error) ? share_text(f.median_error) : "–", time_text(f.core_seconds)}});
    }
    table.notes.push_back(
        "Outer: with what the runs leave out and its plan bounds by numbers. Narrow: the value's own interval is below "
        "15 % of it.");
    return table;
}

ReportTable parts_table(const ValidatedCase& one) {
    ReportTable table{
        "What U_val is made of",
        {words("Quantity"), words("method"), numbers("scatter"), numbers("discretisation"), numbers("box, choices"),
         numbers("input"), numbers("truth"), words("convergence"), words("values by size, finest first")}};
    for (const std::string& estimator : uncertainty_methods())
        if (estimator != uncertainty_methods().front())
            table.columns.push_back(numbers(uncertainty_method_label(estimator)));
    const std::string sizes_of_all = common_sizes(one);
    for (const ValidatedQuantity& q : one.quantities)
        for (const ValidatedValue& v : q.values) {
            if (!std::isfinite(v.value)) continue;
            std::string values, inputs;
            for (const auto& [spacing, value] : v.sizes)
                values += fmt::format("{}{:.4g}", values.empty() ? "" : ", ", value);
            if (sizes_of_all.empty()) values += " at " + spacings_text(v);
            for (const auto& [name, U] : v.inputs)
                inputs += fmt::format("{}{}: {:.3g}", inputs.empty() ? "input: " : ", ", name, U);
            const std::string order = std::isfinite(v.order) ? fmt::format(", order {:.2g}", v.order) : "";
            ReportRow row{{quantity_text(q), method_label(v.method), v.statistical, v.discretisation, v.choices,
                           v.input, q.truth.half_width, v.convergence + order, values},
                          inputs};
            for (std::size_t k = 1; k < uncertainty_methods().size(); ++k) {
                const auto by = std::ranges::find(v.by_method, uncertainty_methods()[k], &MethodEstimate::method);
                row.cells.emplace_back(by == v.by_method.end() ? nan : by->uncertainty);
            }
            table.rows.push_back(std::move(row));
        }
    // What is nothing or unknown in all rows says nothing: scatter, box and input of many cases, methods that need more
    // sizes.
    for (std::size_t k = table.columns.size(); k-- > 2;)
        if (table.columns[k].align == ReportColumn::Align::right &&
            std::ranges::none_of(table.rows, [&](const ReportRow& r) {
                return std::isfinite(r.cells[k].number) && r.cells[k].number != 0;
            })) {
            table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(k));
            for (ReportRow& row : table.rows) row.cells.erase(row.cells.begin() + static_cast<std::ptrdiff_t>(k));
        }
    if (!sizes_of_all.empty() && !table.empty()) table.notes.push_back("Sizes at the body: " + sizes_of_all + ".");
    return table;
}

ReportTable estimators_table(const ValidationReport& report) {
    ReportTable table{"The same by other methods for the discretisation error",
                      {words("Discretisation error by"), words("method"), numbers("has an interval"),
                       numbers("interval holds"), numbers("narrow ones that hold"), numbers("its median U")}};
    for (const EstimatorSummary& e : estimators_of(report))
        table.rows.push_back(
            {{uncertainty_method_label(e.estimator), run_cell(method_label(e.method), method_rank(e.method)),
              share(e.given, e.values), share(e.holds, e.given), share(e.narrow_holds, e.narrow),
              std::isfinite(e.median_U) ? share_text(e.median_U) : "–"}});
    table.notes.push_back(
        "Scatter, box, input and the truth's uncertainty are the same for all. GCI: Celik et al. 2008, Fs = 1.25, of "
        "the three finest sizes. Eça & Hoekstra 2014: least squares, of four sizes and more. Factor of safety: Xing & "
        "Stern 2010, monotone values only. Median U: of the discretisation error alone, in per cent of the truth.");
    return table;
}

ReportTable cost_table(const ValidatedCase& one) {
    ReportTable table{"Cost, all sizes together",
                      {words("method"), numbers("runs"), numbers("processor time", "s"), numbers("wall time", "s")}};
    for (const CaseCost& c : one.costs)
        table.rows.push_back({{method_label(c.method), c.runs, c.core_seconds, c.seconds}});
    return table;
}

ReportTable change_table(const std::vector<ValidationChange>& changes, const std::string& since) {
    static const char* const names[] = {"worse", "better", "new", "gone"};
    static constexpr Mark marks[] = {Mark::bad, Mark::good, Mark::none, Mark::open};
    ReportTable table{since.empty() ? "What changed" : "What changed since " + since,
                      {words("Value"), words("change"), words("was"), words("is")}};
    for (const ValidationChange& c : changes) {
        const auto kind = static_cast<std::size_t>(c.kind);
        table.rows.push_back({{c.what, ReportCell(names[kind], marks[kind]), c.was, c.is}});
    }
    return table;
}

}  // namespace tw
