#include "compare/sweep/sweep_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/report/comparison_tables.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw {

ReportTable sweep_summaries(const Sweep& sweep) {
    if (sweep.methods.size() < 2) return {};
    const bool matrix = sweep.methods.size() > 2;
    ReportTable table{"Bias and scatter between the methods", {words("Quantity"), words("unit"), numbers("scenes")}};
    if (matrix) table.columns.push_back(words("methods"));
    for (const std::string& name :
         {matrix ? "bias" : "bias, " + method_label(sweep.methods[1]) + " over " + method_label(sweep.methods[0]),
          std::string("its 95 % interval"), std::string("scatter"), std::string("left out")})
        table.columns.push_back(numbers(name));
    for (const SweepSummary& s : sweep.summaries) {
        ReportRow row{{s.label, s.unit, s.points.size()}};
        if (matrix)
            row.cells.emplace_back(method_label(sweep.methods[s.b]) + " over " + method_label(sweep.methods[s.a]));
        row.cells.emplace_back(ratio_text(s.bias));
        row.cells.emplace_back(std::isfinite(s.interval)
                                   ? ratio_text(s.bias - s.interval) + " … " + ratio_text(s.bias + s.interval)
                                   : "–");
        row.cells.emplace_back(std::isfinite(s.scatter) ? factor_text(std::exp(s.scatter)) : "–");
        row.cells.emplace_back(s.left_out);
        table.rows.push_back(std::move(row));
    }
    table.notes.push_back(
        "Bias: mean of the logarithm of the ratio, as a percentage. Scatter: factor of its standard deviation. Left "
        "out: a value is missing or 0, or the signs differ.");
    return table;
}

ReportTable sweep_values(const Sweep& sweep) {
    if (sweep.methods.size() < 2) return {};
    const bool matrix = sweep.methods.size() > 2;
    ReportTable table{"Scene by scene", {words("Quantity"), words("unit"), words("Scene")}};
    if (matrix) table.columns.push_back(words("methods"));
    for (const std::string& name : matrix ? std::vector<std::string>{"the second", "the first"}
                                          : std::vector{method_label(sweep.methods[0]), method_label(sweep.methods[1])})
        table.columns.push_back(numbers(name));
    for (const ReportColumn& column : {numbers("relative"), words("verdict"), words("discretisation error")})
        table.columns.push_back(column);
    for (const SweepSummary& s : sweep.summaries)
        for (const auto& p : s.points) {
            const SweepMember& member = sweep.members[p.member];
            ReportRow row{{s.label, s.unit, member.name}};
            if (matrix)
                row.cells.emplace_back(method_label(sweep.methods[s.a]) + ", " + method_label(sweep.methods[s.b]));
            row.cells.emplace_back(value_text(p.a, p.Ua));
            row.cells.emplace_back(value_text(p.b, p.Ub));
            const double ratio = p.b / p.a;
            row.cells.emplace_back(std::abs(std::log(ratio)) > std::log(10)
                                       ? factor_text(ratio)
                                       : per_cent_text(100 * (ratio - 1), 100 * p.U / std::abs(p.a)));
            row.cells.push_back(verdict_cell(p.verdict));
            row.cells.emplace_back(p.verdict == Verdict::not_estimated ? "not estimated" : member.discretisation_from);
            table.rows.push_back(std::move(row));
        }
    table.notes.push_back(
        "± is the 95 % interval. Where the discretisation error is not estimated it holds the statistical scatter of "
        "the means alone; where it is from another scene's twins it was taken relative to the values.");
    return table;
}

ReportTable sweep_scenes(const Sweep& sweep) {
    ReportTable table{"The scenes", {words("Scene"), words("comparison"), words("report or reason")}};
    for (const SweepMember& m : sweep.members)
        table.rows.push_back({{m.name, m.why_not.empty() ? ReportCell("yes") : ReportCell("no comparison", Mark::open),
                               m.why_not.empty() ? m.report : m.why_not}});
    return table;
}

}  // namespace tw
