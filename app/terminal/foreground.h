#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw::app {

/// Runs a program without a shell, and before the user's eyes; with `silent` what it prints is not shown. Gives its
/// exit status, or 128 + signal. Throws InputError where it cannot be started.
int run_in_foreground(const std::filesystem::path& program, std::vector<std::string> words, bool silent = false);

}  // namespace tw::app
