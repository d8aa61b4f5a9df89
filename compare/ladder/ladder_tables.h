#pragma once
#include "compare/ladder/ladder.h"
#include "compare/report/report_table.h"

namespace tw {

// The tables of a ladder: the page, the text and the terminal print the same ones.

ReportTable ladder_verdicts(const Ladder& ladder);
/// Each method's finest values beside what was measured, or a formula says.
ReportTable ladder_held(const Ladder& ladder);
/// Values of every size, and what the estimators make of them.
ReportTable ladder_values(const Ladder& ladder);
/// Every share of each interval, in per cent of the value.
ReportTable ladder_shares(const Ladder& ladder);
/// The runs with another box, sound speed, time step or Courant number.
ReportTable ladder_variations(const Ladder& ladder);
/// What accuracy costs.
ReportTable ladder_prices(const Ladder& ladder);
ReportTable ladder_runs(const Ladder& ladder);
/// Checks and certificate lines that some run does not meet.
ReportTable ladder_checks(const Ladder& ladder);

}  // namespace tw
