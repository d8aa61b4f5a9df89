#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw::app {

/// What tells the hulls' files apart: their stems, with as many of the folders before them as that takes, and the ending
/// where the same name has several.
std::vector<std::string> hull_labels(const std::vector<std::filesystem::path>& hulls);

}  // namespace tw::app
