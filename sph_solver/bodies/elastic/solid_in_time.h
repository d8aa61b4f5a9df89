#pragma once
#include <memory>

#include "sph_solver/bodies/elastic/structure_in_time.h"

namespace tw {

/// A solid advanced by central differences (structure/time/central_difference.h) in equal sub-steps under its own
/// forces, the pressure that follows its surface and a floor's contact, each as it is then. The water's load is an
/// impulse in the middle of a step, where the water finds it (the impulse method: Tuckerman, Berne & Martyna 1992,
/// doi:10.1063/1.463137), as of rigid bodies:
///
///   v += (dt' + dt)/2 M^-1 f_water(u);   dt/2 and dt/2 to where the water looks next: M dv/dt = -F(u) + p(u) + c(u)
///
/// dt' being the step before. The water is shown the velocity w = (u_next - u)/dt with which it is compressed by as
/// much as the surface moves from one look to the next, so the two of them swing without gaining energy. The integrator
/// stands where the water looks, half a step ahead of the water; energies are those of that moment.
///
/// A sub-step is no longer than `of_limit` of 2 / omega, omega^2 the sum of the highest of an element at the start and
/// of the contact. Dummies follow the outward normals of the faces; nodes that a rigid part carries do not turn.
///
/// Throws InputError where `setup` has strain gauges, which only shells carry; `restore` throws std::invalid_argument
/// where the state has another number of unknowns. `setup` must outlive it.
std::unique_ptr<StructureInTime> solid_in_time(const ElasticSetup& setup);

}  // namespace tw
