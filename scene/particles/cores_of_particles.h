#pragma once
#include "scene/scene.h"

namespace tw {

/// Cores that a particle run of a scene is predicted with: those of this machine, which ranks share, unless each has
/// threads of its own.
double cores_of_particles(const Scene& scene);

}  // namespace tw
