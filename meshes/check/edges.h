#pragma once
#include <cstdint>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// One use of an edge by a triangle.
struct EdgeUse {
    int low, high;  ///< point numbers, low < high
    int triangle;
    bool forward;  ///< the triangle runs from low to high
};

/// The uses of an edge, side by side: [begin, end) in Edges::uses.
struct Edge {
    std::size_t begin, end;
    std::size_t count() const { return end - begin; }
};

/// All edges of a surface with the triangles that use them.
struct Edges {
    std::vector<EdgeUse> uses;  ///< sorted by low, high, triangle
    std::vector<Edge> edges;
    bool open(const Edge& e) const { return e.count() == 1; }
    bool non_manifold(const Edge& e) const { return e.count() > 2; }
    /// Two neighbours that run along their edge in the same direction have opposite normals.
    bool flipped(const Edge& e) const { return e.count() == 2 && uses[e.begin].forward == uses[e.begin + 1].forward; }
};
Edges find_edges(const Surface& surface);

/// Triangles connected through edges.
struct Shells {
    std::vector<int> of_triangle;  ///< shell number
    int count = 0;
};
Shells find_shells(const Surface& surface, const Edges& edges);

/// A closed chain of open edges, in the direction in which a filling triangle would run along them.
using Loop = std::vector<int>;  ///< point numbers
/// The holes of a surface whose rims are simple; a rim that touches itself is left out.
std::vector<Loop> find_holes(const Surface& surface, const Edges& edges);

}  // namespace tw
