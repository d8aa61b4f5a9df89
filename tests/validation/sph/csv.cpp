#include "csv.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tw::test {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

}  // namespace

std::size_t Csv::column(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::out_of_range("no column " + name);
    return static_cast<std::size_t>(found - names.begin());
}

std::vector<double> Csv::numbers(const std::string& name) const {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(std::stod(row.at(column(name))));
    return values;
}

Csv read_csv(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    Csv csv;
    std::string line;
    while (std::getline(in, line)) {
        if (line.starts_with('#')) continue;  // where the data are from
        if (csv.names.empty())
            csv.names = cells_of(line);
        else
            csv.rows.push_back(cells_of(line));
    }
    return csv;
}

}  // namespace tw::test
