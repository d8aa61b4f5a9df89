#pragma once
#include <vector>

#include "compare/report/report_table.h"
#include "compare/sweep/sweep.h"

namespace tw {

/// For every hull and trim that was run at two speeds or more: resistance, power, attitude and wetted length by each
/// method and each formula, a column for each speed, and on a page their curves above it. Runs of one
/// method have theirs too. Empty: no hull was run at several speeds.
std::vector<ReportTable> over_the_speed(const Sweep& sweep);

}  // namespace tw
