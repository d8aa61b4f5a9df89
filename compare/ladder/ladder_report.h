#pragma once
#include <string>
#include <vector>

#include "compare/ladder/ladder.h"
#include "compare/report/report_table.h"

namespace tw {

// A grid-convergence study in sentences, tables and files.

/// The verdict on two sides as a sentence to be forwarded, see sentence_of.
std::string ladder_sentence(const Ladder& ladder, const LadderQuantity& quantity, const LadderDifference& difference);
/// The sentence on the quantity's own difference.
std::string ladder_sentence(const Ladder& ladder, const LadderQuantity& quantity);
/// "Beyond 82 s, at U = 688 N, fvm is the cheaper one, before it sph.", for every two; empty where the lines do not
/// cross within a year.
std::string crossover_sentence(const Ladder& ladder, const LadderQuantity& quantity);
/// Tables and verdicts for people, in markdown.
std::string ladder_text(const Ladder& ladder);
/// A part of it for the terminal: the verdicts, the comparison with measurements, and the checks that are not met.
std::string ladder_summary(const Ladder& ladder);
std::string ladder_json(const Ladder& ladder);
/// Spacing and values of one side, as `twinwake uncertainty` reads it; levels that lack a quantity leave it out whole.
std::string ladder_csv(const Ladder& ladder, std::size_t side);
/// The part of report.html that stands below the verdicts: convergence, shares, other choices, what accuracy costs.
std::string ladder_html(const Ladder& ladder);
/// The lines above the tables: runs that are left out, choices that are no evidence, sides that are no family.
std::vector<std::string> ladder_banners(const Ladder& ladder);

// The tables of a ladder: the page, the text and the terminal print the same ones.

ReportTable ladder_verdicts(const Ladder& ladder);
/// Each method's finest values beside what was measured, or a formula says.
ReportTable ladder_held(const Ladder& ladder);
/// Validity checks that some run does not meet.
ReportTable ladder_checks(const Ladder& ladder);
/// Behind these, in the order in which they stand: every share of each interval; the values of every size and what the
/// estimators make of them; the runs with another box, sound speed, time step or Courant number; what accuracy costs; the
/// runs.
std::vector<ReportTable> ladder_details(const Ladder& ladder);

}  // namespace tw
