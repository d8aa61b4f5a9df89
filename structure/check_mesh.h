#pragma once
#include <filesystem>

#include "structure/mesh.h"

namespace tw::structure {

/// Refuses what no structure can be made of. Throws InputError with the file and the element's number there:
///   - a quadrilateral without area or not convex; a hexahedron without volume or turned inside out at a corner;
///   - quadrilaterals side by side that are turned opposite ways: the plate's upper face would change over;
///   - elements that hang together with the first one by no node.
void check_mesh(const MeshFile& mesh, const std::filesystem::path& file);

}  // namespace tw::structure
