#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace tw {

/// The outer surface of a drawing, STEP or (`iges`) IGES, cut into triangles [m]; the file names its own unit. Chords
/// stay within `cad_chord` times the diagonal of the drawing's box, and normals of neighbours within 12 degrees. Where
/// it holds solids, these alone are taken; else all faces, sewn where their edges lie within 1e-5 of the diagonal of
/// each other. `file` is named in messages, `readable` is read, in a child process. Throws InputError: not such a file,
/// no faces, faces that cannot be cut, a crash of the library, or a program without Open CASCADE.
vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path& readable,
                                      bool iges);
inline constexpr double cad_chord = 2e-4;

}  // namespace tw
