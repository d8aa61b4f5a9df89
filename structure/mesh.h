#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace tw::structure {

/// Named groups of nodes, by index.
using NodeSets = std::map<std::string, std::vector<int>>;

/// A plate or shell by its mid-surface: quadrilaterals whose corners turn counter-clockwise about the normal.
struct ShellMesh {
    std::vector<Vec3> nodes;  ///< [m]
    std::vector<std::array<int, 4>> quads;
    NodeSets sets;
};

/// A solid: hexahedra in the order of VTK (the lower face counter-clockwise seen from above, then the upper one), and
/// the quadrilaterals of its named surfaces, outward.
struct SolidMesh {
    std::vector<Vec3> nodes;  ///< [m]
    std::vector<std::array<int, 8>> hexahedra;
    std::vector<int> material;  ///< of each hexahedron
    NodeSets sets;
    std::map<std::string, std::vector<std::array<int, 4>>> surfaces;
};

}  // namespace tw::structure
