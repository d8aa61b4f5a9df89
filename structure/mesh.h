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
    std::vector<Vec3> nodes;                    ///< [m]
    std::vector<std::array<int, 8>> hexahedra;  ///< places of the corners among the nodes
    std::vector<int> material;                  ///< of each hexahedron
    NodeSets sets;
    std::map<std::string, std::vector<std::array<int, 4>>> surfaces;
};

/// What a mesh file holds. Each kind keeps the nodes that its elements use, in the order of the file's numbers; node
/// sets lose the others.
struct MeshFile {
    ShellMesh shell;                                    ///< of quadrilaterals; the node sets are here
    SolidMesh solid;                                    ///< of hexahedra; the same nodes' sets
    std::vector<std::string> materials;                 ///< name of each material number of the solid
    std::vector<int> quad_numbers, hexahedron_numbers;  ///< that the elements have in the file
};

}  // namespace tw::structure
