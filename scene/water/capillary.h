#pragma once
#include "scene/scene.h"

namespace tw {

/// With the effect surface_tension: the speed whose head is the capillary pressure 2 sigma/h of the sharpest curvature that
/// particles know, sqrt(4 sigma / (rho h)); a capillary wave of that length, k = 1/h, has half of it [m/s]. Else 0.
double capillary_speed(const Scene& scene);

/// The most that the water's surface can give to its motion [J], in two dimensions of what is solved: sigma times the faces
/// of the blocks of water that stand on no wall, less, where none stands on one, the circle's or sphere's of the same
/// volume. 0 without surface tension.
double surface_energy(const Scene& scene);

}  // namespace tw
