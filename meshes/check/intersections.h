#pragma once
#include <utility>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Pairs of triangles that pass through each other or lie upon each other, at most `limit` of them, in a fixed order.
/// Neighbours that only share a corner or an edge, as they should, are not meant.
std::vector<std::pair<int, int>> find_intersections(const Surface& surface, std::size_t limit = 1000);

}  // namespace tw
