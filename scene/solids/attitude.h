#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

/// What is odd about how the hull of a scene stands in the water, as findings of level warning:
///   submerged       its highest point lies under still water
///   swamped         part of its deck (what faces up) lies under still water
///   barely_wet      the part under still water is narrower than one particle spacing in some direction
///   narrow_part     a step, chine or rail of its bottom is finer than the size at the hull
///   stern_first     in a stream: its blunt end faces the stream
std::vector<Finding> check_attitude(const Scene& scene);

}  // namespace tw
