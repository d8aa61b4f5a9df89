#include <fmt/format.h>

#include <cmath>

#include "compare/ladder/judge_by_sizes.h"
#include "compare/ladder/ladder_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {

std::string crossover_sentence(const Ladder& ladder, const LadderQuantity& q) {
    std::string out;
    if (q.values.size() < 2) return out;
    for (const LadderDifference& d : q.differences()) {
        const CostOfAccuracy &a = q.values[d.a].cost, &b = q.values[d.b].cost;
        const double seconds = crossover_seconds(a, b), U = a.uncertainty_after(seconds);
        if (!(seconds > 1) || !(seconds < 3e7) || no_more_than_rounding(U, d.size)) continue;
        const bool first_steeper = a.slope > b.slope;
        out += fmt::format("{}Beyond {}, at U = {} {}, {} is the cheaper one, before it {}.", out.empty() ? "" : " ",
                           time_text(seconds), U, for_terminal(q.unit),
                           for_terminal(method_label(ladder.sides[first_steeper ? d.a : d.b].method)),
                           for_terminal(method_label(ladder.sides[first_steeper ? d.b : d.a].method)));
    }
    return out;
}

std::vector<std::string> ladder_banners(const Ladder& ladder) {
    std::vector<std::string> lines;
    for (const LadderSide& side : ladder.sides)
        if (!side.similar)
            lines.push_back("The " + method_label(side.method) +
                            " runs differ in more than their resolution: they do not form a family.");
    for (const auto* list : {&ladder.notes, &ladder.left_out}) lines.insert(lines.end(), list->begin(), list->end());
    return lines;
}

std::string validation_label(const Validation& v) {
    switch (v.verdict) {
        case Verdict::agree: return "yes";
        case Verdict::undecided: return "yes, by a wide interval";
        case Verdict::differ: return "no";
        case Verdict::not_converged: return "not converged";
        case Verdict::not_comparable:
        case Verdict::not_estimated: break;
    }
    return "no value";
}

std::string cores_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "–";
    const double core_seconds = cost.seconds_for(uncertainty);
    if (core_seconds > 3.6e9) return "over a million";
    return (cost.measured(core_seconds) ? "" : "~") + plain_number(core_seconds / 3600, 2);
}

std::string memory_text(const CostOfAccuracy& cost, double uncertainty) {
    if (!cost.known() || !(uncertainty > 0)) return "–";
    const double bytes = cost.seconds_for(uncertainty);
    return fmt::format("{}{}", cost.measured(bytes) ? "" : "~",
                       bytes < 1e9    ? plain_number(bytes / 1e6, 2) + " MB"
                       : bytes < 1e13 ? plain_number(bytes / 1e9, 2) + " GB"
                                      : std::string("over 10 TB"));
}

std::string ladder_sentence(const Ladder& ladder, const LadderQuantity& q, const LadderDifference& d) {
    return for_terminal(sentence_of(statement_of(ladder, q, d)));
}

std::string ladder_sentence(const Ladder& ladder, const LadderQuantity& q) { return ladder_sentence(ladder, q, q); }

namespace {

std::string text_of_all(const std::vector<ReportTable>& tables) {
    std::string out;
    for (const ReportTable& table : tables)
        if (!table.empty()) out += "\n" + text_of(table);
    return out;
}

}  // namespace

std::string ladder_summary(const Ladder& ladder) {
    std::string out;
    for (const LadderQuantity* q : main_quantities(ladder.quantities))
        for (const LadderDifference& d : q->differences()) out += ladder_sentence(ladder, *q, d) + "\n";
    out += text_of_all({ladder_verdicts(ladder), ladder_held(ladder), ladder_checks(ladder)});
    for (const std::string& line : ladder_banners(ladder)) out += "\n! " + for_terminal(line) + "\n";
    return out;
}

std::string ladder_text(const Ladder& ladder) {
    std::string out = fmt::format("# {}\n\n", for_terminal(ladder.title)) + ladder_summary(ladder) + "\n";
    for (const LadderQuantity& q : ladder.quantities)
        if (!is_main_quantity(q.name))
            for (const LadderDifference& d : q.differences()) out += "- " + ladder_sentence(ladder, q, d) + "\n";
    out += text_of_all({ladder_values(ladder), ladder_shares(ladder), ladder_variations(ladder), ladder_prices(ladder),
                        ladder_runs(ladder)});
    if (ladder_held(ladder).empty())
        for (const std::string& line : ladder.calibrated) out += "\nTuned, not validated: " + for_terminal(line) + "\n";
    return out;
}

std::string ladder_csv(const Ladder& ladder, std::size_t side) {
    const std::vector<LadderRun>& runs = ladder.sides.at(side).runs;
    ReportTable table{"", {numbers("near_hull", "m")}};
    for (const LadderRun& run : runs) table.rows.push_back({{run.spacing}});
    for (const LadderQuantity& q : ladder.quantities) {
        const std::vector<StudyLevel>& levels = q.values[side].levels;
        if (levels.size() != runs.size()) continue;
        table.columns.push_back(numbers(q.name, q.unit));
        for (std::size_t i = 0; i < levels.size(); ++i) table.rows[i].cells.emplace_back(levels[i].value);
    }
    return csv_of(table);
}

}  // namespace tw
