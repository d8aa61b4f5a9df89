#pragma once
#include "compare/ablate/ablation.h"
#include "compare/report/report_table.h"

namespace tw {

// The tables of an ablation: the page and the terminal print the same ones.

/// Every effect against the quantities that matter most; the heading is the method.
ReportTable ablation_overview(const Ablation& ablation, const AblationMethod& method);
/// One effect switched, with every quantity.
ReportTable ablation_details(const Ablation& ablation, const AblationRow& row, const std::string& method);
/// What was not run or did not finish, and why.
ReportTable ablation_missing(const Ablation& ablation);

/// One quantity's change in a row; null: not there.
const AblationChange* change_in(const AblationRow& row, const std::string& name);
/// A quantity's name for people.
std::string change_label(const AblationMethod& method, const std::string& name);

/// What the numbers mean; stands below the overview.
inline constexpr const char* ablation_note =
    "Changes in per cent of the value before, with the 95 % intervals of both runs combined; the discretisation error "
    "is "
    "not in them. A change beyond its interval is marked; chance alone does that once in twenty times. Processor time: "
    "of solving, per simulated second, of one run each; a busy machine changes it by several per cent.";

}  // namespace tw
