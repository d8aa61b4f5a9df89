#pragma once
#include <filesystem>

#include "structure/mesh.h"

namespace tw::structure {

/// Reads an unstructured grid of VTK's XML format: its quadrilaterals and hexahedra, numbered from 0 as ParaView shows
/// them. Every array of one value per point is a node set, of the points where it is not 0. Throws InputError for a
/// file that VTK cannot read, for a cell of another kind, and for a grid without cells.
MeshFile read_vtu(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
