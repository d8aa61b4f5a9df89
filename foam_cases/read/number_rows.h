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

/// Names of times have at least six digits: two that differ by less, relatively, are one.
inline constexpr double time_name_precision = 1e-5;

/// One start of the solver, and the file in which a function object kept a table then.
struct Segment {
    double start = 0;  ///< [s]
    std::filesystem::path file;
};
/// The files of one table (`file`, e.g. "force.dat") in the order of the solver's starts: every start-time folder
/// (postProcessing/forces/0, .../0.25), and in each the plain name before those with a time behind it: openfoam.com
/// begins "force_0.dat" beside "0/force.dat" when it starts from 0 once more.
std::vector<Segment> segments(const std::filesystem::path& function_object, const std::string& file);

/// Rows of all segments, joined: each start replaces what the starts before it have computed beyond its start time.
/// Each row begins with its time, and times increase. Rows that a killed solver or a full disk left unfinished (not as
/// long as most) are dropped.
std::vector<std::vector<double>> joined_rows(const std::filesystem::path& function_object, const std::string& file);

}  // namespace tw
