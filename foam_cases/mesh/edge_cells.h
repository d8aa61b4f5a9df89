#pragma once
#include <vector>

#include "meshes/shedding_edges.h"

namespace tw {

/// The smallest of the cells whose middles lie within `reach` [m] of an edge that lies across the stream, over the
/// volume `whole` [m3]: 1 where there is none. Below a tenth, snapping has squeezed a cell below the edge to a wedge
/// against the face behind it, and water is sucked round the edge into it (docs/decisions/028-shedding-edges.md).
double smallest_edge_cell(const std::vector<Vec3>& middles, const std::vector<double>& volumes,
                          const std::vector<SheddingEdge>& edges, double reach, double whole);

}  // namespace tw
