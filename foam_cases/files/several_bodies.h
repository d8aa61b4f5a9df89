#pragma once
#include "foam_cases/case_plan.h"
#include "foam_cases/dictionary.h"

namespace tw {

/// constant/dynamicMeshDict where several free bodies move: OpenFOAM's rigidBodyMotion, a joint to the earth for each,
/// the mesh morphed round all of them. Its Newmark rule has the gyroscopic term, unlike that of sixDoFRigidBodyMotion.
/// `q`, `qDot`, `qDdot`: places, velocities and accelerations at the start by joint, all bodies in a row.
Dictionary several_bodies(const CasePlan& plan);

/// The rule by which OpenFOAM moves one body, or several.
Dictionary newmark(const CasePlan& plan);

}  // namespace tw
