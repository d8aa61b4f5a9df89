#pragma once
#include <vector>

#include "motion/motion_law.h"

namespace tw {

/// The rows of a table of a prescribed motion, which OpenFOAM reads as its own spline: every hundredth of the run or
/// finer, one before, and behind as far as the longest step leads, because the last one may begin just before the end
/// and a table that ends earlier ends the run [s].
std::vector<double> times_of_table(const MotionLaw& law, double duration, double longest_step);

}  // namespace tw
