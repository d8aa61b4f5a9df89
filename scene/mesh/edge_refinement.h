#pragma once
#include <vector>

#include "meshes/shedding_edges.h"
#include "scene/scene.h"

namespace tw {

/// Finer cells of the mesh method along the edges from which a stream leaves the hull.
struct EdgeRefinement {
    std::vector<SheddingEdge> edges;  ///< in the solved part of the domain; none: nothing is refined
    int halvings = 0;                 ///< of the cells of size near_hull
    double reach = 0;                 ///< cells whose middles lie nearer than this to an edge are halved [m]
};

/// Hulls in a stream and three dimensions: one halving within one cell of near_hull of the edges that may be wet. With
/// cells of one size the water does not leave a transom's lower edge where the edge lies badly in its cells: it turns
/// round it into the first cell behind, whose suction was up to a sixth of the drag (docs/decisions/028-shedding-edges.md).
/// Sections have finer cells all round (foam_cases/plan_case.cpp).
EdgeRefinement edge_refinement(const Scene& scene);

}  // namespace tw
