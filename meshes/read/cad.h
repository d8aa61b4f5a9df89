#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

#include "meshes/read/named_solid.h"

namespace tw {

/// The outer surface of a drawing, STEP or (`iges`) IGES, cut into triangles [m]; the file names its own unit. Chords
/// stay within `cad_chord` times the diagonal of the drawing's box, and normals of neighbours within 12 degrees. Where
/// it holds solids, these alone are taken; else all faces, sewn where their edges lie within 1e-5 of the diagonal of
/// each other. `solid`: of a STEP file only what has this name (empty: all). `file` is named in messages, `readable` is
/// read, in a child process. Throws InputError: not such a file, no faces, faces that cannot be cut, no solid of that
/// name, a crash of the library, or a program without Open CASCADE.
vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path& readable,
                                      bool iges, const std::string& solid = {});
inline constexpr double cad_chord = 2e-4;

/// The names of each solid of a STEP file, in its order. Read and throws like the surface.
std::vector<SolidNames> solids_in_step(const std::filesystem::path& file, const std::filesystem::path& readable);

}  // namespace tw
