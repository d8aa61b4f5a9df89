#pragma once
#include "compare/compare.h"
#include "compare/report/report_table.h"

namespace tw {

// The tables of a comparison: the page and the terminal print the same ones.

/// Values and differences: those that get a verdict where one can be given, or what is shown beside them.
ReportTable quantities_table(const Comparison& comparison, bool judged);
/// What the intervals do not contain, for the main quantities: what the runs leave out, by their effect plan, and the
/// outer intervals with it. Empty where nothing is known to be left out.
ReportTable left_out_table(const Comparison& comparison);
/// How the settled means were taken.
ReportTable settling_table(const Comparison& comparison);
/// Validity checks of the record and of the run itself; `failed_only`: those that are not met.
ReportTable checks_table(const std::vector<ValidityCheck>& checks, bool failed_only);
ReportTable effects_table(const Comparison& comparison);
ReportTable cost_table(const Comparison& comparison);
ReportTable provenance_table(const Comparison& comparison);

/// Where a run has several sizes of particles: who is in each at the last frame, what passed the edge of its zone, and
/// its part of the time. Empty where all runs have one size.
ReportTable levels_table(const Comparison& comparison);

/// A verdict in words, with the mark that makes it stand out.
ReportCell verdict_cell(Verdict verdict);

}  // namespace tw
