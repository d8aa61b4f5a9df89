#pragma once
#include <filesystem>
#include <string_view>

#include "meshes/surface.h"

namespace tw {

// STL is read here and not by vtkSTLReader, which guesses the kind of file by bytes above 127: it takes a text with
// such a letter in its first lines for a binary file, whose number of triangles the letters spell, and some binary
// files whose header begins with "solid" for text. Corners are not yet welded. Both throw InputError naming the file
// (and the line), what was found, what was expected.

/// True when the content is an ascii STL file; judged by its text, because binary files may begin with "solid" too.
bool is_ascii_stl(std::string_view content);
/// True when the size is what the header's number of triangles makes, whatever the header says else.
bool is_binary_stl(std::string_view content);
/// A size other than the promised number of triangles has is refused.
Surface read_binary_stl(const std::filesystem::path& file, std::string_view content);
/// Facets, loops and vertices in their order with three numbers each, closed by endsolid.
Surface read_ascii_stl(const std::filesystem::path& file, std::string_view content);

}  // namespace tw
