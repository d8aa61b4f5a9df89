#pragma once
#include "compare/compare.h"
#include "compare/report/report_table.h"

namespace tw {

/// Where a run has several sizes of particles: who is in each at the last frame, what passed the edge of its zone, and
/// its part of the time. Empty where all runs have one size.
ReportTable levels_table(const Comparison& comparison);

}  // namespace tw
