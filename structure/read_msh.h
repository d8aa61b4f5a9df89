#pragma once
#include <filesystem>

#include "structure/mesh.h"

namespace tw::structure {

/// Reads Gmsh's mesh format, ASCII, 4.1 or 2.2 (https://gmsh.info/doc/texinfo/gmsh.html, "MSH file format"):
/// quadrilaterals and hexahedra; points and lines count for the node sets alone. The nodes of the elements of a
/// physical group are a node set of its name, or GROUP_n without one. Throws InputError with file and line: another
/// version or a binary file, an element of another kind, a node that is not there, a number that is none, a section
/// without its end, and for a file without elements.
MeshFile read_msh(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
