#pragma once
#include "scene/scene.h"

namespace tw {

/// Largest Courant number of the mesh method's run, where a scene gives none [-]. Domain and sizes are known.
double default_courant(const Scene& scene);

}  // namespace tw
