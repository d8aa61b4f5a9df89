#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tw::test {

/// A comma-separated table with a head line; cells as text.
struct Csv {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;
    std::size_t column(const std::string& name) const;  ///< throws std::out_of_range naming it
    std::vector<double> numbers(const std::string& name) const;
};
Csv read_csv(const std::filesystem::path& file);

}  // namespace tw::test
