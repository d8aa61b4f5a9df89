#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// Why the particles of a scene cannot be shared by several ranks; empty: they can.
std::string why_not_over_ranks(const Scene& scene);

/// Throws InputError with the reason.
void refuse_ranks(const Scene& scene, int ranks);

}  // namespace tw
