#pragma once
#include <vector>

#include "compare/report/report_table.h"
#include "compare/sweep/sweep.h"

namespace tw {

/// For every hull and trim that was run at two speeds or more: resistance, power, attitude and wetted length; for all that
/// was run in two wave lengths or more: responses, accelerations, forces of the wave and what it adds to the drag. By each
/// method, each formula and each measurement, a column for each speed or length, and on a page their curves above it. Runs
/// of one method have theirs too. Empty: nothing was varied so.
std::vector<ReportTable> swept_curves(const Sweep& sweep);

}  // namespace tw
