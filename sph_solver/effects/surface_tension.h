#pragma once
#include <memory>

#include "sph_solver/effects/effect.h"

namespace tw {

/// Surface tension as a force per volume in the surface's kernel width (Brackbill, Kothe & Zemach 1992,
/// doi:10.1016/0021-9991(92)90240-Y; for particles Morris 2000):
///
///   du/dt += 2 sigma / rho (-div n^) grad C,   grad C = sum_j grad_i W_ij V_j (into the water),   n^ = grad C / |grad
///   C|
///
/// Only the water's half of the surface layer is there, hence the 2. The divergence is renormalised over the neighbours
/// that have a normal (|grad C| > 0.15/h). Walls count as water in grad C, so that a wetted wall is no surface and the
/// contact angle is about 90 degrees. Momentum is kept to the error of the curvature, not pair by pair. It wants
/// h/dp = 2: a drop's period is then 5 % off with 15 spacings in the radius and 1 % with 25, at 1.5 by 20 %
/// (docs/validation.md).
struct SurfaceTension {
    double sigma = 0.072;  ///< [N/m]
};
std::unique_ptr<Effect> make_surface_tension(const SurfaceTension& options);

}  // namespace tw
