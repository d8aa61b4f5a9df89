#pragma once
#include <filesystem>
#include <string>

namespace tw::app {

// What scenes that the program writes are made of.

/// As a basic string of TOML.
std::string quoted(const std::string& text);
/// `file` as the scene names it: relative to the folder of the scene.
std::string seen_from(const std::filesystem::path& scene, const std::filesystem::path& file);
/// The step to which a number is rounded for a reader: ten to a hundred of it make `value` (> 0).
double step_of(double value);
/// `value` rounded up to whole steps.
double rounded_up(double value, double step);

}  // namespace tw::app
