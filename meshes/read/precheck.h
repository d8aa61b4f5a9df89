#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace tw {

// The readers of VTK trust their files: a count that promises more than the file holds makes them crash, allocate
// without bound or return nothing without a word. These look at the structure first. All throw InputError naming the
// file (and the line, in text files), what was found, what was expected and what to do.

/// Vertices with three numbers; faces of at least three corners that exist.
void check_obj(const std::filesystem::path& file, std::string_view content);
/// An XML file of `type` (PolyData, UnstructuredGrid) that is complete.
void check_vtk_xml(const std::filesystem::path& file, std::string_view content, const std::string& type);

}  // namespace tw
