#pragma once
#include <optional>
#include <string>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"

namespace tw {

/// Stops that a free body needs and OpenFOAM lacks, in plain words; nothing while all is well: a body faster than it
/// could have become (ten times its first speed and that of the tank's height, most often its added mass blowing up), or,
/// in water that began at rest, with more energy than weight and buoyancy can have given it; one that reaches the floor or a wall of the tank, one that has come so far that the morphed mesh is about to fold.
std::optional<std::string> body_trouble(const CasePlan& plan, const SolverLog& log);

}  // namespace tw
