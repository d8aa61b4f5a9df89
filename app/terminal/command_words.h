#pragma once
#include <map>
#include <string>
#include <vector>

namespace tw::app {

/// The words of a command line without these options. The number says how many values an option takes: 0 or 1, in the
/// same word behind "=" or in the next.
std::vector<std::string> without_options(const std::vector<std::string>& words,
                                         const std::map<std::string, int>& options);

/// What was called, for the records: a word a line, without where results went and how and on how many cores they were
/// made. Of a path from the root the name is left.
std::string command_text(const std::vector<std::string>& words);

}  // namespace tw::app
