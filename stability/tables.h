#pragma once
#include "compare/report/report_table.h"
#include "stability/map.h"

namespace tw {

// The tables of the stability map: the page and the terminal print the same ones.

/// One map: a row for each value of y, a column for each of x; "!" ran with a warning, "X" failed.
ReportTable map_table(const StabilityMap& map);
/// Every cell that is not stable, once, with the reason.
ReportTable unstable_cells(const std::vector<StabilityMap>& maps);
/// The validity checks with their limits and the reasons of these.
ReportTable limits_of_the_map();

}  // namespace tw
