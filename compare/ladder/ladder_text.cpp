#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ladder/ladder.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"

namespace tw {

namespace {

std::string number(double v, const char* digits = "{:.5g}") {
    return std::isfinite(v) ? fmt::format(fmt::runtime(digits), v) : "-";
}

std::string runs_table(const Ladder& ladder) {
    std::string out =
        "| method | spacing at the hull [m] | particles or cells | wall time [s] | predicted [s] | core hours | memory "
        "[MB] |\n|---|---|---|---|---|---|---|\n";
    const auto row = [&](const std::string& method, const LadderRun& r) {
        out += fmt::format("| {} | {:g} | {:.3g} | {:.3g} | {} | {:.3g} | {:.3g} |\n", for_terminal(method), r.spacing,
                           r.elements, r.seconds,
                           r.predicted_seconds > 0 ? fmt::format("{:.3g}", r.predicted_seconds) : "-",
                           r.core_seconds / 3600, r.memory / 1e6);
    };
    for (const LadderSide& side : ladder.sides) {
        for (const LadderRun& r : side.runs) row(side.method, r);
        for (const LadderVariation& v : side.variations) row(side.method + ", " + v.name, v.run);
    }
    return out;
}

/// Times to 5, 2 and 1 % of the size; "~" where outside the times of the levels.
std::string cost_row(const std::string& method, const LadderValue& v, double size) {
    if (v.levels.empty()) return {};
    if (!v.cost.known())
        return fmt::format("| {} | - | - | - | - | {} | - | - |\n", for_terminal(method), v.cost.why_not);
    std::string out = fmt::format("| {} | {:.2f} |", for_terminal(method), v.cost.slope);
    for (const double share : {0.05, 0.02, 0.01}) {
        const double seconds = v.cost.seconds_for(share * size);
        out += fmt::format(" {}{} |", v.cost.measured(seconds) ? "" : "~", time_text(seconds));
    }
    return out + fmt::format(" x {:.3g} | {} | {} |\n", v.cost.price_of_halving(),
                             cores_text(v.cost_in_cores, 0.02 * size), memory_text(v.cost_in_memory, 0.02 * size));
}

std::string quantity_text(const Ladder& ladder, const LadderQuantity& q) {
    std::string out = fmt::format(
        "\n## {} [{}]\n\n| method | values, finest first | half width of the mean | order | class | U of the "
        "resolution | GCI | factor of safety | U |\n|---|---|---|---|---|---|---|---|---|\n",
        q.label, q.unit);
    std::string notes, costs;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        const std::string method = for_terminal(ladder.sides[k].method);
        std::string values;
        for (const Level& l : v.levels) values += (values.empty() ? "" : ", ") + number(l.value);
        const Estimate& e = v.estimate;
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", method, values,
                           number(v.statistical, "{:.3g}"), number(e.order, "{:.2f}"), to_string(e.convergence),
                           number(e.uncertainty, "{:.3g}"), number(e.celik_gci.uncertainty, "{:.3g}"),
                           number(e.xing_stern.uncertainty, "{:.3g}"),
                           std::isfinite(v.uncertainty) && q.size > 0
                               ? fmt::format("{:.3g} ({:.2g} %)", v.uncertainty, 100 * v.uncertainty / q.size)
                               : "-");
        if (!v.levels.empty()) notes += fmt::format("- {}: {}\n", method, verdict_sentence(e));
        for (const Sensitivity& s : v.sensitivities)
            if (s.idle())
                notes += fmt::format("- {}, {} at {:g} m: the same to the last digit\n", method, s.name, s.spacing);
            else if (std::isfinite(s.uncertainty))
                notes += fmt::format("- {}, {} at {:g} m: {} instead of {}, U {}\n", method, s.name, s.spacing,
                                     number(s.varied), number(s.value), number(s.uncertainty, "{:.3g}"));
        for (const std::string& why : v.absent) notes += fmt::format("- {} at {}\n", method, for_terminal(why));
        costs += cost_row(ladder.sides[k].method, v, q.size);
    }
    if (!notes.empty()) out += "\n" + notes;
    if (!costs.empty())
        out +=
            "\n| method | slope of U over time | time to 5 % | to 2 % | to 1 % | halving U costs | core hours to 2 % | "
            "memory "
            "to 2 % |\n|---|---|---|---|---|---|---|---|\n" +
            costs;
    if (const std::string crossover = crossover_sentence(ladder, q); !crossover.empty()) out += crossover + "\n";
    return out;
}

}  // namespace

std::string crossover_sentence(const Ladder& ladder, const LadderQuantity& q) {
    if (q.values.size() != 2) return {};
    const double seconds = crossover_seconds(q.values[0].cost, q.values[1].cost);
    if (!(seconds > 1) || !(seconds < 3e7)) return {};
    const bool first_steeper = q.values[0].cost.slope > q.values[1].cost.slope;
    return fmt::format("Beyond {}, at U = {:.3g} {}, {} is the cheaper one, before it {}.", time_text(seconds),
                       q.values[0].cost.uncertainty_after(seconds), q.unit,
                       for_terminal(ladder.sides[first_steeper ? 0 : 1].method),
                       for_terminal(ladder.sides[first_steeper ? 1 : 0].method));
}

std::string validation_label(const Validation& v) {
    switch (v.verdict) {
        case Verdict::agree: return "yes";
        case Verdict::undecided: return "yes, by a wide interval";
        case Verdict::differ: return "no";
        case Verdict::not_converged: return "not converged";
        case Verdict::not_comparable: break;
    }
    return "no value";
}

std::string cores_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "-";
    const double core_seconds = cost.seconds_for(uncertainty);
    if (core_seconds > 3.6e9) return "over a million";
    return fmt::format("{}{:.2g}", cost.measured(core_seconds) ? "" : "~", core_seconds / 3600);
}

std::string memory_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "-";
    const double bytes = cost.seconds_for(uncertainty);
    return fmt::format("{}{}", cost.measured(bytes) ? "" : "~",
                       bytes < 1e9    ? fmt::format("{:.2g} MB", bytes / 1e6)
                       : bytes < 1e13 ? fmt::format("{:.2g} GB", bytes / 1e9)
                                      : std::string("over 10 TB"));
}

std::string time_text(double seconds) {
    if (!std::isfinite(seconds)) return "-";
    if (seconds < 120) return fmt::format("{:.2g} s", seconds);
    if (seconds < 7200) return fmt::format("{:.2g} min", seconds / 60);
    if (seconds < 172800) return fmt::format("{:.2g} h", seconds / 3600);
    if (seconds < 3e7) return fmt::format("{:.2g} days", seconds / 86400);
    return "more than a year";
}

std::string ladder_sentence(const LadderQuantity& q) {
    std::string out = q.label + ": " + verdict_label(q.verdict);
    if (std::isfinite(q.interval))
        out += fmt::format(", {} {} ({})", signed_text(q.difference, q.interval), q.unit, per_cent_text(q.per_cent));
    else if (std::isfinite(q.difference))
        out += fmt::format("; the finest differ by {:+.4g} {} ({})", q.difference, q.unit, per_cent_text(q.per_cent));
    return q.reason.empty() ? out : out + ": " + for_terminal(q.reason);
}

std::string ladder_text(const Ladder& ladder) {
    std::string out = fmt::format("# {}\n\n", for_terminal(ladder.title)) + runs_table(ladder);
    for (const LadderSide& side : ladder.sides)
        if (!side.similar)
            out += fmt::format("\n! The {} runs differ in more than their resolution: no family.\n",
                               for_terminal(side.method));
    for (const LadderQuantity& q : ladder.quantities)
        if (std::ranges::any_of(q.values, [](const LadderValue& v) { return !v.levels.empty(); }))
            out += quantity_text(ladder, q);
    out += "\n## Verdicts\n\n";
    for (const LadderQuantity& q : ladder.quantities) out += "- " + ladder_sentence(q) + "\n";
    std::string held;
    for (const LadderQuantity& q : ladder.quantities)
        for (const Held& h : q.held)
            for (std::size_t k = 0; k < h.validations.size(); ++k) {
                const Validation& v = h.validations[k];
                held += fmt::format("| {} [{}] | {} | {} | {} | {} ({}) | {} | {} |\n", q.label, q.unit,
                                    for_terminal(h.source), mean_text(h.value), for_terminal(ladder.sides[k].method),
                                    number(v.E, "{:+.4g}"), per_cent_text(v.per_cent), number(v.U_val, "{:.3g}"),
                                    validation_label(v));
            }
    if (!held.empty())
        out +=
            "\n## Against what was measured, or a formula says\n\n| quantity | source | its value | method | value - "
            "its | "
            "U | within |\n|---|---|---|---|---|---|---|\n" +
            held;
    for (const std::string& line : ladder.left_out) out += "\n! " + for_terminal(line) + "\n";
    for (const std::string& line : ladder.calibrated) out += "\ncalibrated, " + for_terminal(line) + "\n";
    return out + "\n~: beyond the times of this ladder, by its slope. U: half width of the 95 % interval.\n";
}

std::string ladder_csv(const Ladder& ladder, std::size_t side) {
    const std::vector<LadderRun>& runs = ladder.sides.at(side).runs;
    std::string header = "near_hull [m]";
    std::vector<std::string> rows;
    for (const LadderRun& run : runs) rows.push_back(fmt::format("{:.9g}", run.spacing));
    for (const LadderQuantity& q : ladder.quantities) {
        const std::vector<Level>& levels = q.values[side].levels;
        if (levels.size() != runs.size()) continue;
        header += fmt::format(",{} [{}]", q.name, q.unit);
        for (std::size_t i = 0; i < levels.size(); ++i) rows[i] += fmt::format(",{:.9g}", levels[i].value);
    }
    std::string out = header + "\n";
    for (const std::string& row : rows) out += row + "\n";
    return out;
}

}  // namespace tw
