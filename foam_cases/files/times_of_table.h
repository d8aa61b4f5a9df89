#pragma once
#include <vector>

#include "motion/motion_law.h"

namespace tw {

/// The rows of a table of a prescribed motion, which OpenFOAM reads as its own spline: every hundredth of the run or
/// finer, and one before and one behind, because the solver looks a step ahead [s].
std::vector<double> times_of_table(const MotionLaw& law, double duration);

}  // namespace tw
