#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string_view>

namespace tw {

/// The points and polygons of a PLY file, ascii or binary, its elements in any order. It is read here and not by
/// vtkPLYReader, which crashes on elements before the vertices and takes the rows of others for faces. Throws
/// InputError naming the file: unsound header, counts that promise more than there is, corners that do not exist.
vtkSmartPointer<vtkPolyData> read_ply(const std::filesystem::path& file, std::string_view content);

}  // namespace tw
