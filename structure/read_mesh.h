#pragma once
#include <filesystem>

#include "structure/mesh.h"

namespace tw::structure {

/// Reads a mesh by its file's ending: .inp (read_inp.h), .msh (read_msh.h) or .vtu (read_vtu.h), lengths in
/// `metres_per_unit`, and checks it (check_mesh.h). Throws InputError that begins with the file.
MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit = 1);

}  // namespace tw::structure
