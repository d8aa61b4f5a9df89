#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// What would make a comparison say more, as a reader would do it.
struct NextStep {
    std::string what;     ///< "Simulate longer: the means need about 0.9 s more."
    std::string command;  ///< for a shell
};
/// The most useful first, at most three.
std::vector<NextStep> next_steps(const Comparison& comparison);

}  // namespace tw
