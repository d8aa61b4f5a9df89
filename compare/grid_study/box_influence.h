#pragma once
#include "compare/grid_study/grid_study.h"

namespace tw {

/// Puts what a run in a wider box has measured in place of what was expected of the walls: how much they change each
/// load, extrapolated to open water (steps.h). It is said where a change is above 2 %, or was expected to be.
void add_measured_box(Comparison& comparison, const GridStudy& grid_study);

}  // namespace tw
