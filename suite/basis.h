#pragma once
#include <string>

#include "suite/suite.h"

namespace tw {

// What a value is made for, from the case as it is written now: the parts of a ValueBasis. All throw InputError: a
// scene or a file that it needs cannot be read.

/// The scene's hash, its duration and the numbers that it or the case calls uncertain; of the method's numerics and of
/// how a run begins what the scene file says. What it does not say are the program's defaults, and its version stands
/// beside each value.
std::string scene_digest(const SuiteScene& scene, const std::string& method);
/// Unit and reading of the quantity, number of sizes and their ratio.
std::string definition_digest(const SuiteQuantity& quantity, const SuiteScene& scene);
/// Of a measured truth its mapping and the files that this names (a folder counts by its name only); else empty: other
/// truths are those of now, whenever a value was made.
std::string truth_digest(const SuiteQuantity& quantity);

}  // namespace tw
