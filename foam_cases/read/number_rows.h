#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tw {

/// All numbers of a line, whatever stands between them (blanks, tabs, parentheses).
std::vector<double> numbers_in(std::string_view line);

/// Time that a folder's name spells ("0.25", "1e-05"); nothing for other names.
std::optional<double> time_of(std::string_view folder_name);

/// Rows of `file` in every start-time folder of one function object (postProcessing/forces/0, .../0.25), joined: where
/// a restart has computed times again, the later start wins. Each row begins with its time, and times increase. Rows
/// that a killed solver left unfinished (shorter than the others) are dropped.
std::vector<std::vector<double>> joined_rows(const std::filesystem::path& function_object, const std::string& file);

}  // namespace tw
