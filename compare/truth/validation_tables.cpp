#include "compare/truth/validation_report.h"

#include <fmt/format.h>

#include <cmath>

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

std::vector<ReportColumn> value_columns() {
    return {words("Quantity"), words("unit"), numbers("truth"), words("standing"), words("method"),
            numbers("value"),  numbers("E"),  numbers("U_val"), numbers("goal"),   words("verdict")};
}

void add_values(ReportTable& table, const ValidatedCase& c, bool named) {
    for (const ValidatedQuantity& q : c.quantities)
        for (const ValidatedValue& v : q.values) {
            ReportRow row;
            if (named) row.cells.emplace_back(c.name);
            row.cells.insert(row.cells.end(),
                             {q.label, q.unit, value_text(q.truth.value, q.truth.half_width), q.truth.standing});
            row.cells.push_back(run_cell(method_label(v.method), method_rank(v.method)));
            row.cells.emplace_back(value_text(v.value, v.U_num));
            row.cells.emplace_back(!std::isfinite(v.E) ? std::string("–")
                                   : q.scale > 0       ? per_cent_text(100 * v.E / q.scale)
                                                       : signed_text(v.E, v.U_val));
            row.cells.emplace_back(in_per_cent(q, v.U_val));
            row.cells.emplace_back(in_per_cent(q, q.goal));
            row.cells.push_back(outcome_cell(v.outcome));
            const auto known = q.known_miss.find(v.method);
            if (known != q.known_miss.end() && falls_short(v, q)) row.remark = "known: " + known->second;
            if (v.outcome == Outcome::failed || v.outcome == Outcome::not_converged) row.remark = v.why_not;
            table.rows.push_back(std::move(row));
        }
}

std::string share(int some, int all) { return all == 0 ? "–" : fmt::format("{} of {}", some, all); }

}  // namespace

ReportTable validation_table(const ValidationReport& report) {
    ReportTable table{"Every value against its truth", value_columns()};
    table.columns.insert(table.columns.begin(), words("Case"));
    for (const ValidatedCase& c : report.cases) add_values(table, c, true);
    table.notes.push_back(
        "E: value less truth. U_val: half width of the 95 % interval of E, from discretisation, scatter, input and the "
        "truth's own uncertainty (ASME V&V 20). Per cent are of the truth, or of what the suite says.");
    table.notes.push_back(
        "Met: abs(E) is below U_val and U_val below the goal. Undecided: U_val is above the goal. Within the goal, "
        "outside its interval: abs(E) is below the goal and above U_val. Missed: abs(E) is above both.");
    return table;
}

ReportTable validation_table(const ValidatedCase& one) {
    ReportTable table{"", value_columns()};
    add_values(table, one, false);
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
    ReportTable table{"What U_val is made of",
                      {words("Quantity"), words("unit"), words("method"), numbers("scatter"), numbers("discretisation"),
                       numbers("box, choices"), numbers("input"), numbers("truth"), numbers("U_val"),
                       words("convergence"), numbers("order"), words("values by size, finest first")}};
    for (const ValidatedQuantity& q : one.quantities)
        for (const ValidatedValue& v : q.values) {
            if (!std::isfinite(v.value)) continue;
            std::string sizes;
            for (const auto& [spacing, value] : v.sizes)
                sizes += fmt::format("{}{:.4g} ({:.3g} mm)", sizes.empty() ? "" : ", ", value, 1e3 * spacing);
            std::string inputs;
            for (const auto& [name, U] : v.inputs)
                inputs += fmt::format("{}{}: {:.3g}", inputs.empty() ? "input: " : ", ", name, U);
            table.rows.push_back({{q.label, q.unit, method_label(v.method), v.statistical, v.discretisation, v.choices,
                                   v.input, q.truth.half_width, v.U_val, v.convergence, v.order, sizes},
                                  inputs});
        }
    return table;
}

ReportTable estimators_table(const ValidatedCase& one) {
    ReportTable table{"The discretisation error by each method",
                      {words("Quantity"), words("unit"), words("method"), numbers("value")}};
    for (const std::string& estimator : uncertainty_methods()) {
        table.columns.push_back(numbers(uncertainty_method_label(estimator)));
        if (estimator != uncertainty_methods().front()) table.columns.push_back(numbers("its order"));
    }
    for (const ValidatedQuantity& q : one.quantities)
        for (const ValidatedValue& v : q.values) {
            if (!std::isfinite(v.value) || v.by_method.empty()) continue;
            ReportRow row{{q.label, q.unit, run_cell(method_label(v.method), method_rank(v.method)),
                           value_text(v.value, v.U_num)}};
            for (const MethodEstimate& m : v.by_method) {
                row.cells.emplace_back(m.uncertainty);
                if (m.method != uncertainty_methods().front()) row.cells.emplace_back(m.order);
                if (!m.why_not.empty())
                    row.remark +=
                        (row.remark.empty() ? "" : "; ") + uncertainty_method_label(m.method) + ": " + m.why_not;
            }
            table.rows.push_back(std::move(row));
        }
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
