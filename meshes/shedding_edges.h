#pragma once
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// A straight piece of an edge of a hull from which a stream along +x leaves.
struct SheddingEdge {
    Vec3 from, to;  ///< [m]
    Vec3 inward;    ///< unit vector into the solid, halfway between its two faces [-]
};

/// The edges of a posed hull from which water leaves: the lower edge of a transom, chines, bilges, steps. Such an edge is
/// sharper than 30 degrees and convex, and ends a bottom: one of its faces looks down and not astern, the other neither
/// does so nor looks ahead. Keels (both faces look down) and the lower edge of a bow (water arrives there) are none. What
/// lies outside `within` is cut off [m]. A smooth hull has none.
std::vector<SheddingEdge> shedding_edges(const Surface& hull, const Box& within);

/// Sum of their lengths [m].
double length_of(const std::vector<SheddingEdge>& edges);

/// A ribbon of triangles that starts at the edges and reaches `width` [m] into the solid: edges as a surface, for programs
/// that measure distances to surfaces.
Surface ribbon(const std::vector<SheddingEdge>& edges, double width);

}  // namespace tw
