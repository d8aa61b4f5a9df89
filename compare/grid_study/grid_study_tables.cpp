#include "compare/grid_study/grid_study_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/comparison_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {

namespace {

bool has_levels(const GridStudyQuantity& q) {
    return std::ranges::any_of(q.values, [](const GridStudyValue& v) { return !v.levels.empty(); });
}

ReportCell method_cell(const GridStudy& grid_study, std::size_t k, const std::string& more = {}) {
    return run_cell(method_label(grid_study.sides[k].method) + more, k);
}

/// An uncertainty in the value's unit; "none" where it is no more than rounding.
std::string uncertainty_cell(double U, double value) {
    if (!std::isfinite(U)) return "–";
    return no_more_than_rounding(U, value) ? "none" : number_text(U);
}

/// The difference in per cent.
std::string relative_text(const GridStudyDifference& d, const GridStudyQuantity& q) {
    if (!std::isfinite(d.per_cent)) return "–";
    const auto finest = [&](std::size_t k) { return q.values[k].levels.front().value; };
    return difference_text(d.per_cent, 100 * d.interval / d.size, of_scale(d.size, finest(d.a), finest(d.b), q.unit));
}

std::string joined(const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : "; ") + part;
    return out;
}

/// Whether the measured value lies within the interval.
std::string validation_label(const Validation& v) {
    switch (v.verdict) {
        case Verdict::agree: return "yes";
        case Verdict::undecided:
        case Verdict::no_answer: return "yes, by a wide interval";
        case Verdict::differ: return "no";
        case Verdict::not_converged: return "not converged";
        case Verdict::not_comparable:
        case Verdict::not_estimated: break;
    }
    return "no value";
}

constexpr double most_core_seconds = 1e5 * 3600;  ///< nobody has more: a rack of 128 cores for a month

/// Core hours to an uncertainty; "~" where beyond the sizes.
std::string cores_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "–";
    const double core_seconds = cost.seconds_for(uncertainty);
    if (core_seconds > most_core_seconds) return "out of reach";
    return (cost.measured(core_seconds) ? "" : "~") + plain_number(core_seconds / 3600, 2);
}

/// Memory to an uncertainty likewise.
std::string memory_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "–";
    const double bytes = cost.seconds_for(uncertainty);
    return fmt::format("{}{}", cost.measured(bytes) || !(bytes < 1e13) ? "" : "~",
                       bytes < 1e9    ? plain_number(bytes / 1e6, 2) + " MB"
                       : bytes < 1e13 ? plain_number(bytes / 1e9, 2) + " GB"
                                      : std::string("out of reach"));
}

}  // namespace

std::string crossover_sentence(const GridStudy& grid_study, const GridStudyQuantity& q) {
    std::string out;
    if (q.values.size() < 2) return out;
    for (const GridStudyDifference& d : q.differences()) {
        const CostOfAccuracy &a = q.values[d.a].cost, &b = q.values[d.b].cost;
        const double seconds = crossover_seconds(a, b), U = a.uncertainty_after(seconds);
        if (!(seconds > 1) || !(seconds < 3e7) || no_more_than_rounding(U, d.size)) continue;
        const bool first_steeper = a.slope > b.slope;
        out += fmt::format("{}Beyond {}, at U = {} {}, {} is the cheaper one, before it {}.", out.empty() ? "" : " ",
                           time_text(seconds), number_text(U, 2), for_terminal(unit_text(q.unit)),
                           for_terminal(method_label(grid_study.sides[first_steeper ? d.a : d.b].method)),
                           for_terminal(method_label(grid_study.sides[first_steeper ? d.b : d.a].method)));
    }
    return out;
}

ReportTable grid_study_verdicts(const GridStudy& grid_study) {
    ReportTable table{"Verdict of the grid-convergence study", {words("Quantity"), words("unit")}};
    for (std::size_t k = 0; k < grid_study.sides.size(); ++k) {
        table.columns.push_back(numbers(method_label(grid_study.sides[k].method)));
        table.columns.back().source = static_cast<int>(k);
    }
    const bool matrix = grid_study.sides.size() > 2;
    if (matrix) table.columns.push_back(words("between"));
    for (const char* name : {"difference", "relative"}) table.columns.push_back(numbers(name));
    table.columns.push_back(words("verdict"));
    for (const GridStudyQuantity& q : grid_study.quantities) {
        ReportRow row{{q.label, q.unit}};
        for (const GridStudyValue& v : q.values)
            row.cells.emplace_back(v.levels.empty() ? "–" : value_text(v.levels.front().value, v.uncertainty));
        for (const GridStudyDifference& d : q.differences()) {
            if (matrix)
                row.cells.emplace_back(method_label(grid_study.sides[d.b].method) + " − " +
                                       method_label(grid_study.sides[d.a].method));
            row.remark = grid_study.sides.size() > 1 ? d.reason : "";
            row.cells.emplace_back(signed_text(d.difference, d.interval));
            row.cells.emplace_back(relative_text(d, q));
            row.cells.push_back(verdict_cell(d.verdict));
            table.rows.push_back(row);
            row = {std::vector<ReportCell>(2 + q.values.size())};  // its values stand once
            row.cells.front() = q.label;
        }
    }
    table.notes.push_back(fmt::format(
        "Finest values with 95 % intervals that include the statistical scatter of the mean, the "
        "discretisation error (from three sizes on a fit of trend and noise, of two the grid convergence index) and "
        "the runs with other choices. Agree: the difference lies inside the joint interval, and that is at most {:g} % "
        "of the value, or both together are. Differ: it lies outside. Undecided: inside, but the interval is too wide "
        "for a verdict. Not converged: the "
        "values of a method diverge as the sizes shrink, or have no uncertainty. The influence of the walls of the box "
        "is part of the values' intervals and not of that of the difference, because both methods solve the same box.",
        100 * grid_study.agree_within));
    return table;
}

ReportTable grid_study_held(const GridStudy& grid_study) {
    ReportTable table{"Compared with measurements and formulas",
                      {words("Quantity"), words("unit"), words("source"), numbers("its value"), words("method"),
                       numbers("value − its"), numbers("relative"), numbers("U"), words("within U")}};
    for (const GridStudyQuantity& q : grid_study.quantities)
        for (const Held& h : q.held)
            for (std::size_t k = 0; k < h.validations.size(); ++k) {
                const Validation& v = h.validations[k];
                ReportCell label = verdict_cell(v.verdict);
                label.text = validation_label(v);
                table.rows.push_back(
                    {{q.label, q.unit, h.source, mean_text(h.value), method_cell(grid_study, k),
                      signed_text(v.E, v.U_val),
                      per_cent_text(v.per_cent, v.E != 0 ? std::abs(v.per_cent * v.U_val / v.E) : std::nan("")),
                      uncertainty_cell(v.U_val, h.value.value), label}});
            }
    table.notes.push_back(
        "U combines the interval of the finest value and, where one is known, that of the other value (ASME V&V 20). "
        "These values do not enter the verdict between the methods.");
    for (const std::string& line : grid_study.calibrated) table.notes.push_back("Tuned, not validated: " + line);
    return table;
}

ReportTable grid_study_checks(const GridStudy& grid_study) {
    std::vector<ValidityCheck> failed;
    for (const GridStudySide& side : grid_study.sides) {
        const auto add = [&](const GridStudyRun& run, const std::string& choice) {
            for (ValidityCheck check : run.failed_checks) {
                check.source = fmt::format("{} at {} m{}", side.method, number_text(run.spacing), choice);
                failed.push_back(std::move(check));
            }
        };
        for (const GridStudyRun& run : side.runs) add(run, "");
        for (const GridStudyVariation& v : side.variations) add(v.run, ", " + v.name);
    }
    return checks_table(failed, true);
}

namespace {

/// Every share of each interval, in per cent of the value.
ReportTable shares_of_intervals(const GridStudy& grid_study) {
    ReportTable table{
        "Contributions to the intervals, in per cent of the value",
        {words("Quantity"), words("method"), numbers("mean"), numbers("discretisation"), numbers("Eça & Hoekstra"),
         numbers("GCI"), numbers("factor of safety"), numbers("box"), numbers("input"), words("other choices")}};
    bool any_box = false, any_input = false;
    for (const GridStudyQuantity& q : grid_study.quantities)
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const GridStudyValue& v = q.values[k];
            if (v.levels.empty()) continue;
            const auto share = [&](double U) {
                if (!std::isfinite(U) || !(q.size > 0)) return std::string("–");
                return no_more_than_rounding(U, q.size) ? std::string("none") : share_text(100 * U / q.size);
            };
            std::vector<std::string> choices;
            std::string box = "–", input = "–";
            for (const Sensitivity& s : v.sensitivities) {
                const std::string said = !s.refused.empty() ? "no evidence"
                                         : s.idle()         ? "no change"
                                                            : share(s.uncertainty);
                if (s.box)
                    box = said, any_box = true;
                else if (!s.input.empty())
                    input = share(v.input), any_input = true;
                else
                    choices.push_back(s.name + ": " + said);
            }
            table.rows.push_back(
                {{q.label, method_cell(grid_study, k), share(v.statistical), share(v.estimate.uncertainty),
                  share(v.estimate.eca_hoekstra.uncertainty), share(v.estimate.celik_gci.uncertainty),
                  share(v.estimate.xing_stern.uncertainty), box, input, joined(choices)}});
        }
    if (any_input)
        table.notes.push_back(
            "Input: the change of the value when the uncertain numbers of the scene lie at either end of their "
            "intervals, at the coarsest size; like the box it is part of a value's interval and not of that of the "
            "difference.");
    if (any_box)
        table.notes.push_back(
            "Box: the change in a box 1.5 times as wide, deep and long at the coarsest size, extrapolated to open "
            "water (with the inverse of the water's cross section); measured by one method and taken for both.");
    return table;
}

/// Values of every size, and what the estimators make of them.
ReportTable values_by_size(const GridStudy& grid_study) {
    ReportTable table{
        "Values by size",
        {words("Quantity"), words("unit"), words("method"), words("values, finest first"), numbers("± of the mean"),
         numbers("order"), words("class"), numbers("U of the discretisation"), numbers("Eça & Hoekstra"),
         numbers("GCI"), numbers("factor of safety"), numbers("U"), numbers("U [%]")}};
    for (const GridStudyQuantity& q : grid_study.quantities) {
        if (!has_levels(q)) continue;
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const GridStudyValue& v = q.values[k];
            const Estimate& e = v.estimate;
            std::vector<std::string> values;
            for (const StudyLevel& l : v.levels) values.push_back(number_text(l.value, 5));
            const double finest = v.levels.empty() ? 0 : v.levels.front().value;
            const bool some =
                std::isfinite(v.uncertainty) && q.size > 0 && !no_more_than_rounding(v.uncertainty, finest);
            std::vector<std::string> remarks;
            if (!v.levels.empty())
                remarks.push_back(method_label(grid_study.sides[k].method) + ": " + verdict_sentence(e));
            for (const std::string& why : v.absent) remarks.push_back("not at " + why);
            table.rows.push_back(
                {{q.label, q.unit, method_cell(grid_study, k), joined(values), uncertainty_cell(v.statistical, finest),
                  std::isfinite(e.order) ? fmt::format("{:.2f}", e.order) : "–", to_string(e.convergence),
                  uncertainty_cell(e.uncertainty, finest), uncertainty_cell(e.eca_hoekstra.uncertainty, finest),
                  uncertainty_cell(e.celik_gci.uncertainty, finest), uncertainty_cell(e.xing_stern.uncertainty, finest),
                  uncertainty_cell(v.uncertainty, finest), some ? plain_number(100 * v.uncertainty / q.size, 2) : "–"},
                 joined(remarks)});
        }
    }
    table.notes.push_back(
        "U: half width of the 95 % interval. That of the discretisation is by trend and noise from three sizes on, and "
        "contains the scatter from size to size; the bound of Eça and Hoekstra, the grid convergence index and the "
        "factor "
        "of safety are shown for comparison and are not used.");
    return table;
}

/// The runs with another box, sound speed, time step or Courant number.
ReportTable runs_with_other_choices(const GridStudy& grid_study) {
    ReportTable table{"Runs with other choices",
                      {words("Quantity"), words("unit"), words("method"), words("choice"), numbers("spacing", "m"),
                       numbers("value", "", 5), numbers("with that choice", "", 5), numbers("U")}};
    for (const GridStudyQuantity& q : grid_study.quantities)
        for (std::size_t k = 0; k < q.values.size(); ++k)
            for (const Sensitivity& s : q.values[k].sensitivities) {
                if (!std::isfinite(s.value) || (s.box && s.name.find("(as in") != s.name.npos)) continue;
                table.rows.push_back(
                    {{q.label, q.unit, method_cell(grid_study, k), s.name, s.spacing, s.value, s.varied,
                      !s.refused.empty() ? "no evidence"
                      : s.idle()         ? "none"
                                         : uncertainty_cell(s.uncertainty, s.value)}});
            }
    return table;
}

/// What accuracy costs.
ReportTable prices_of_accuracy(const GridStudy& grid_study) {
    ReportTable table{
        "What accuracy costs",
        {words("Quantity"), words("method"), numbers("slope of U over time"), numbers("time to 5 %"), numbers("to 2 %"),
         numbers("to 1 %"), numbers("halving U costs"), numbers("core hours to 2 %"), numbers("memory to 2 %")}};
    for (const GridStudyQuantity& q : grid_study.quantities) {
        if (!has_levels(q)) continue;
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const GridStudyValue& v = q.values[k];
            ReportRow row{{q.label, method_cell(grid_study, k)}};
            if (!v.cost.known() || v.levels.empty()) {
                for (int c = 0; c < 7; ++c) row.cells.emplace_back("–");
                row.remark =
                    method_label(grid_study.sides[k].method) + ": " + (v.levels.empty() ? "no value" : v.cost.why_not);
            } else {
                row.cells.emplace_back(fmt::format("{:.2f}", v.cost.slope));
                for (const double share : {0.05, 0.02, 0.01}) {
                    const double seconds = v.cost.seconds_for(share * q.size);
                    const bool told = v.cost.measured(seconds) || seconds > most_time || seconds < least_time;
                    row.cells.emplace_back((told ? "" : "~ ") + time_text(seconds));
                }
                row.cells.emplace_back(factor_text(v.cost.price_of_halving()));
                row.cells.emplace_back(cores_text(v.cost_in_cores, 0.02 * q.size));
                row.cells.emplace_back(memory_text(v.cost_in_memory, 0.02 * q.size));
            }
            if (const std::string crossover = crossover_sentence(grid_study, q);
                k + 1 == q.values.size() && !crossover.empty())
                row.remark += (row.remark.empty() ? "" : "; ") + crossover;
            table.rows.push_back(std::move(row));
        }
    }
    table.notes.push_back("~: extrapolated beyond the times of this study.");
    return table;
}

ReportTable all_runs(const GridStudy& grid_study) {
    ReportTable table{"The runs of the study",
                      {words("method"), numbers("spacing at the hull", "m"), numbers(elements_of_all(), "", 4),
                       numbers("time steps", "", 5), numbers("wall time"), numbers("predicted"), numbers("core hours"),
                       numbers("memory", "MB", 4)}};
    const auto row = [&](ReportCell method, const GridStudyRun& r) {
        table.rows.push_back(
            {{std::move(method), r.spacing, r.elements, r.steps, time_text(r.seconds),
              r.predicted_seconds > 0 ? time_text(r.predicted_seconds) : "–", r.core_seconds / 3600, r.memory / 1e6}});
    };
    for (std::size_t k = 0; k < grid_study.sides.size(); ++k) {
        for (const GridStudyRun& r : grid_study.sides[k].runs) row(method_cell(grid_study, k), r);
        for (const GridStudyVariation& v : grid_study.sides[k].variations)
            row(method_cell(grid_study, k, ", " + v.name), v.run);
    }
    return table;
}

}  // namespace

std::vector<ReportTable> grid_study_details(const GridStudy& grid_study) {
    return {shares_of_intervals(grid_study), values_by_size(grid_study), runs_with_other_choices(grid_study),
            prices_of_accuracy(grid_study), all_runs(grid_study)};
}

}  // namespace tw
