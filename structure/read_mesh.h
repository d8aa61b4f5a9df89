#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "structure/mesh.h"

namespace tw::structure {

/// What a mesh file holds. Each kind keeps the nodes that its elements use, in the order of the file's numbers; node
/// sets lose the others.
struct MeshFile {
    ShellMesh shell;                                    ///< of quadrilaterals; the node sets are here
    SolidMesh solid;                                    ///< of hexahedra; the same nodes' sets
    std::vector<std::string> materials;                 ///< name of each material number of the solid
    std::vector<int> quad_numbers, hexahedron_numbers;  ///< that the elements have in the file
};

/// Reads a mesh by its file's ending: .inp (read_inp.h), .msh (read_msh.h) or .vtu (read_vtu.h), lengths in
/// `metres_per_unit`, and checks it (check_mesh.h). Throws InputError that begins with the file.
MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
