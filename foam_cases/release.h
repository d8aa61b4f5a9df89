#pragma once
#include "foam_cases/case_plan.h"

namespace tw {

/// Upward acceleration of a free body at its release from rest, by its weight, its buoyancy and its added mass [m/s2].
double first_rise(const MovingBody& body, const Scene& scene);

/// The time steps of the first while, where bodies are released at rest.
void plan_release(CasePlan& plan);

/// A single free body, not a hull, that comes down through the air: released with a velocity, and farther from all water
/// than it moves in its first steps.
bool released_in_air(const CasePlan& plan);

}  // namespace tw
