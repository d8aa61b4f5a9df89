#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// Whether something that the water carries stands in the water of a tank at the start: a free body or hull that is
/// lighter than the water and not thrown in (slower than a tenth of sqrt(g height)).
bool carries_a_body(const Scene& scene);

/// Why the particles of such a scene have one size though it writes a wider spacing; empty where that is not so.
std::string why_one_size_afloat(const Scene& scene);

}  // namespace tw
