#pragma once
#include <vector>

#include "sph_solver/levels/level.h"

namespace tw {

/// Forces of a level's water on the dummies of one body, in the order in which the walls hold them [N] (per metre of
/// width in two dimensions): the other side of the pair forces of the last second sweep (pressure_gradient.h),
///
///   F_j = sum_i V_i V_j (p_i + p_j) F_ij (x_j - x_i)
///
/// over the level's own particles. Their sum is the pressure's part of the body's load, to the rounding of single
/// precision; what edges release (edge_release.h) is not in them.
std::vector<Vec3> forces_on_dummies(Level& level, std::size_t body);

}  // namespace tw
