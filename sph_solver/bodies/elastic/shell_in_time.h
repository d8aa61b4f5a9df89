#pragma once
#include <memory>

#include "sph_solver/bodies/elastic/structure_in_time.h"

namespace tw {

/// A shell advanced by steps of any length, each under a load that acts in its middle:
///
///   M (v' - v)/dt + F((u + u')/2) = f,   u' - u = dt (v + v')/2
///
/// (average acceleration with f at both ends of the step; structure/time). The work of a load over a step is f . (u' -
/// u), and the energy of shell and load is conserved: exactly where F is linear. A length of step costs one
/// factorisation, and the last few are kept, so the water's step is rounded down to 2^(k/4) s, by at most 16 %. At
/// large rotations a step that does not balance is made of equal parts, under the same load: twice as many as the step
/// before, and half as many again where balancing has become easy; 256 at most.
///
/// `setup` must outlive it.
std::unique_ptr<StructureInTime> linear_shell(const ElasticSetup& setup);
std::unique_ptr<StructureInTime> turning_shell(const ElasticSetup& setup);

}  // namespace tw
