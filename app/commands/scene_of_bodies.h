#pragma once
#include <filesystem>
#include <string>

namespace tw::app {

/// A scene file, to be written as `scene`, with one [[body]] for each body that a surface file names, where it lies in
/// that file; one for the whole file if it names none. The tank has room round all of them. Throws InputError where the
/// file cannot be read.
std::string scene_of_bodies(const std::filesystem::path& surface_file, const std::string& unit, const std::string& axes,
                            const std::filesystem::path& scene);

}  // namespace tw::app
