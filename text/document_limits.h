#pragma once
#include <filesystem>
#include <string>

namespace tw {

/// What no document of people needs and the parser of TOML would take any depth and memory for: keys of more than
/// 8 parts (each dot makes a table within a table, and tables are walked by recursion), more than 10 000 tables. Throws
/// InputError `file:line: ...`.
void refuse_senseless_document(const std::string& text, const std::filesystem::path& file);

}  // namespace tw
