#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "structure/mesh.h"

namespace tw::structure {

/// What a mesh file in Abaqus's input format holds; CalculiX, Gmsh and most preprocessors write it.
struct InpMesh {
    ShellMesh shell;                     ///< of elements S4, S4R; the node sets are here
    SolidMesh solid;                     ///< of elements C3D8, C3D8R, C3D8H, C3D8I; the same nodes' sets
    std::vector<std::string> materials;  ///< element set of each material number of the solid
};

/// Reads *NODE, *ELEMENT and *NSET (also GENERATE), names in upper case, lengths in `metres_per_unit`; other keywords
/// are passed over with their data. Each kind keeps the nodes that its elements use; node sets lose the others. Throws
/// InputError with file and line: an element of another type, a node or set that is not there, a number that is none,
/// a node given twice, and for a file without elements.
InpMesh read_inp(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
