#pragma once
#include <memory>

#include "sph_solver/pair_loops/own_sums.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

class Effect;

/// Surface tension, equations/surface_tension.h. Walls count as water, so that a wetted wall is no surface and the
/// contact angle is about 90 degrees. Momentum is kept to the error of the curvature, not pair by pair. It wants
/// h/dp = 2: a drop's period is then 5 % off with 15 spacings in the radius and 1 % with 25, at 1.5 by 20 %
/// (docs/results/air.md).
struct SurfaceTension {
    double sigma = 0.072;  ///< [N/m]
};
std::unique_ptr<Effect> make_effect(const SurfaceTension& options);

// What its pair loops read and write.

/// grad C of each particle [1/m], walls counted; see equations/surface_tension.h.
struct ColourGradientData {
    WaterView water{};
    WallView walls{};
    OwnSums<PackedVelocityDensity> gradient{};
};
/// -div n of each particle [1/m].
struct CurvatureData {
    WaterView water{};
    const PackedVelocityDensity* normal = nullptr;  ///< unit vector, of images too; drho = 1 where it counts, else 0
    OwnSums<float> curvature{};
};

}  // namespace tw
