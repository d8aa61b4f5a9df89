#pragma once
#include <filesystem>
#include <string>

namespace tw::app {

/// The template of a hull in a stream with a surface file as its hull, to be written as `scene`. Draft, speed and size
/// are those of a first look at a hull of this length, width and height; whether it is wetted as it should be is the
/// user's to see. Throws InputError: the file cannot be read.
std::string scene_of_hull(std::string text, const std::filesystem::path& surface_file, const std::string& unit,
                          const std::string& axes, const std::filesystem::path& scene);

}  // namespace tw::app
