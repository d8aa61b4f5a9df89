#pragma once
#include "compare/report/report_table.h"
#include "compare/sweep/sweep.h"

namespace tw {

// The tables of a sweep: the page and the terminal print the same ones.

/// Bias and scatter between the methods, a row for each quantity.
ReportTable sweep_summaries(const Sweep& sweep);
/// Every quantity, scene by scene.
ReportTable sweep_values(const Sweep& sweep);
/// The scenes, with the reason where there is no comparison.
ReportTable sweep_scenes(const Sweep& sweep);

}  // namespace tw
