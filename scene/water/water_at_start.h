#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace tw {

/// What `check` says of the blocks of water: which of them are one water, at what level that stands or that it is let
/// go, and what particles of this size cannot show. One sentence each, without its end; none for a lone block between
/// walls.
std::vector<std::string> water_at_start(const Scene& scene);

}  // namespace tw
