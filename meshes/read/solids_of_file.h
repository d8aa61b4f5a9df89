#pragma once
#include <filesystem>
#include <vector>

#include "meshes/read/named_solid.h"

namespace tw {

/// The names of each solid of a STEP, OBJ or ascii STL file, in its order; empty: a kind of file that names none, or no
/// solid in it. Throws InputError like read_surface.
std::vector<SolidNames> solids_of_file(const std::filesystem::path& file);

/// For each body of a file one name that takes it, and no solid twice: of each solid the first of its names that no other
/// solid has; where there is none, its own, and then all solids that have this one are one body. Solids without any name
/// are left out.
std::vector<std::string> names_of_bodies(const std::vector<SolidNames>& solids);

}  // namespace tw
