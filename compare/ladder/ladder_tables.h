#pragma once
#include <vector>

#include "compare/ladder/ladder.h"
#include "compare/report/report_table.h"

namespace tw {

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
