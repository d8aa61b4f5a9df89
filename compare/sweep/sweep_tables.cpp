#include "compare/sweep/sweep_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/report/comparison_tables.h"
#include "compare/report/numbers.h"

namespace tw {

ReportTable sweep_summaries(const Sweep& sweep) {
    if (sweep.methods.size() != 2) return {};
    ReportTable table{"Bias and scatter between the methods",
                      {words("Quantity"), words("unit"), numbers("scenes"),
                       numbers("bias, " + sweep.methods[1] + " over " + sweep.methods[0]), numbers("its 95 % interval"),
                       numbers("scatter"), numbers("left out")}};
    for (const SweepSummary& s : sweep.summaries)
        table.rows.push_back(
            {{s.label, s.unit, s.points.size(), ratio_text(s.bias),
              std::isfinite(s.interval) ? ratio_text(s.bias - s.interval) + " … " + ratio_text(s.bias + s.interval)
                                        : "–",
              std::isfinite(s.scatter) ? fmt::format("× {:.3g}", std::exp(s.scatter)) : "–", s.left_out}});
    table.notes.push_back(
        "Bias: mean of the logarithm of the ratio, as a percentage. Scatter: factor of its standard deviation. Left "
        "out: a value is missing or 0, or the signs differ.");
    return table;
}

ReportTable sweep_values(const Sweep& sweep) {
    if (sweep.methods.size() != 2) return {};
    ReportTable table{
        "Scene by scene",
        {words("Quantity"), words("unit"), words("Scene"), numbers(sweep.methods[0]), numbers(sweep.methods[1]),
         numbers("relative"), words("verdict"), words("discretisation error")}};
    for (const SweepSummary& s : sweep.summaries)
        for (const auto& p : s.points)
            table.rows.push_back(
                {{s.label, s.unit, sweep.members[p.member].name, value_text(p.a, p.Ua), value_text(p.b, p.Ub),
                  per_cent_text(100 * (p.b / p.a - 1), 100 * p.U / std::abs(p.a)), verdict_cell(p.verdict),
                  p.verdict == Verdict::not_estimated ? "not estimated"
                                                      : sweep.members[p.member].discretisation_from}});
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
