#pragma once
#include "scene/scene.h"

namespace tw {

/// Mass of the water that moves with a body [kg]: of a plate as long and wide as it is (pi/4 rho b^2 l; half of that
/// where it lies in the surface), or its own volume, if larger; of a hull the plate alone, because most of its volume
/// is dry.
double added_mass(const MovingBody& body, const Scene& scene);

}  // namespace tw
