#pragma once
#include <memory>

#include "sph_solver/effects/effect.h"

namespace tw {

/// Surface tension, equations/surface_tension.h. Walls count as water, so that a wetted wall is no surface and the
/// contact angle is about 90 degrees. Momentum is kept to the error of the curvature, not pair by pair. It wants
/// h/dp = 2: a drop's period is then 5 % off with 15 spacings in the radius and 1 % with 25, at 1.5 by 20 %
/// (docs/results/surface_tension.md).
struct SurfaceTension {
    double sigma = 0.072;  ///< [N/m]
};
std::unique_ptr<Effect> make_surface_tension(const SurfaceTension& options);

}  // namespace tw
