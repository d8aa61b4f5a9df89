#pragma once
#include <string>
#include <vector>

#include "compare/report/report_table.h"
#include "compare/truth/validation.h"

namespace tw {

// The tables of a validation report, the same on the terminal, the page and in the documentation.

/// A row per case, quantity and method: truth, value, E, U_val, goal, what became of it.
ReportTable validation_table(const ValidationReport& report);
/// The same of one case, without its name.
ReportTable validation_table(const ValidatedCase& one);
/// How many intervals hold the truth, by family and method.
ReportTable family_table(const ValidationReport& report);
/// What U_val is made of, with the values of all sizes.
ReportTable parts_table(const ValidatedCase& one);
/// What each method makes of the sizes of every value.
ReportTable estimators_table(const ValidatedCase& one);
/// How often the intervals of each method hold the truth.
ReportTable estimators_table(const ValidationReport& report);
ReportTable cost_table(const ValidatedCase& one);
/// `since`: the earlier report's name; empty: it is not said.
ReportTable change_table(const std::vector<ValidationChange>& changes, const std::string& since);

}  // namespace tw
