#pragma once
#include <optional>

#include "meshes/surface.h"

namespace tw {

/// Bounds of the hull's bottom within `part`; none where nothing of it lies there. Its bottom is what looks down: on
/// topsides no jet is born.
std::optional<Box> bottom_within(const Surface& hull, const Box& part);

}  // namespace tw
