#pragma once
#include <vector>

#include "meshes/check/edges.h"

namespace tw {

/// One closed part of a surface.
struct ShellState {
    double volume = 0;  ///< signed [m3]
    Box bounds;
    int within = -1;               ///< the smallest other shell that encloses it; -1: none
    Vec3 a_corner = Vec3::Zero();  ///< [m]
};
/// Meaningful when every edge is shared by two triangles and the normals of each shell are consistent.
std::vector<ShellState> examine_shells(const Surface& surface, const Shells& shells);

}  // namespace tw
