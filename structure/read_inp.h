#pragma once
#include <filesystem>

#include "structure/mesh.h"

namespace tw::structure {

/// Reads Abaqus's input format, which CalculiX, Gmsh and most preprocessors write: *NODE, *ELEMENT (S4, S4R; C3D8,
/// C3D8R, C3D8H, C3D8I; the element set is the material's name) and *NSET (also GENERATE), names in upper case, lengths
/// in `metres_per_unit`; other keywords are passed over with their data. Throws InputError with file and line: an element of another type, a node or set that is not there, a number that is none,
/// a node given twice, and for a file without elements.
MeshFile read_inp(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
