#pragma once
#include <memory>

#include "sph_solver/bodies/elastic/structure_in_time.h"

namespace tw {

/// A solid advanced by central differences (structure/time/central_difference.h) in equal sub-steps of a step of the
/// water, under its own forces, the pressure that follows its surface and a floor's contact, each as it is then, and the
/// water's load, which stays through the step:
///
///   M dv/dt = f_water - F(u) + p(u) + c(u)
///
/// A sub-step is no longer than `of_limit` of 2 / omega, omega^2 the sum of the highest of an element at the start and
/// of the contact. Dummies follow the outward normals of the faces; nodes that a rigid part carries do not turn.
///
/// `setup` must outlive it.
std::unique_ptr<StructureInTime> solid_in_time(const ElasticSetup& setup);

}  // namespace tw
