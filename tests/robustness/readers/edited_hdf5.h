#pragma once
#include <filesystem>
#include <string_view>

namespace tw::readers {

/// Changes an HDF5 file through HDF5 itself, so that all it says of its own bytes stays right and what it means does not:
/// an array or attribute gets another value in one place, another length, or is gone. Twelve bytes an edit: which one (2),
/// where and how (2), the value (8, a double).
void edit_hdf5(const std::filesystem::path& file, std::string_view edits);

}  // namespace tw::readers
