#pragma once
#include "scene/scene.h"

namespace tw {

/// Throws InputError with the reason: so many ranks cannot share the particles of this scene.
void refuse_ranks(const Scene& scene, int ranks);

}  // namespace tw
