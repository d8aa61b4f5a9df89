#pragma once
#include "compare/compare.h"
#include "statistics/settled_mean.h"

namespace tw {

/// When a column of this record has a mean. `allowed_error`: standard error that is fine whatever the mean [unit of the
/// column].
SettledRules settled_rules(const RunRecord& record, const CompareOptions& options, double allowed_error = 0);
/// Settled mean of one column of a record under the rules of `options`; unknown with a reason when it has no such
/// column. `allowed_error` as above. In a stream with a wave it is the mean over the last whole periods.
MeanValue mean_of(const RunRecord& record, const std::string& table, const std::string& column,
                  const CompareOptions& options, double allowed_error = 0);

/// Drag, lift and trim moment of the water on the hull (judged) and what stands beside them (not judged): pressure and
/// friction parts, the air's part and the total of a method that solves air, ventilation index and friction corrected
/// for it, SPH's three force measures and their spread. Where only one side has friction, pressure parts are compared
/// and that is said.
void add_forces(Comparison& comparison, const CompareOptions& options);

/// `friction_line`: friction of a flat plate on what each method finds wet (column friction_line of `samples`, ITTC 1957),
/// beside; and `total_drag`, judged: drag and friction together, by this line where a record's drag has none. Nothing
/// where no record has the line. The remark has the coefficients over rho U^2/2 S: C_T of the total, C_F of friction.
void add_total_drag(Comparison& comparison, const CompareOptions& options);

/// The total drag, or the drag itself where every source has friction in it; null: it is not known.
const Quantity* resistance_of(const Comparison& comparison);
/// Effective power and resistance coefficient of that, beside the verdict (names effective_power, resistance_coefficient).
void add_resistance(Comparison& comparison, const CompareOptions& options);
/// Wetted length [m].
void add_wetted_length(Comparison& comparison, const CompareOptions& options);

}  // namespace tw
