#pragma once
// Reference tables of tests/data as rows of numbers by column name.
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "test_paths.h"

namespace tw {

/// One row of a table: column name -> what stands there ("" where empty).
using Row = std::map<std::string, std::string>;

inline std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

inline std::vector<Row> table_of(const std::string& file) {
    std::ifstream in(std::string(TWINWAKE_TEST_DATA) + "/" + file);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error("no table " + file);
    const std::vector<std::string> names = cells_of(line);
    std::vector<Row> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = cells_of(line);
        Row row;
        for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = k < cells.size() ? cells[k] : "";
        rows.push_back(std::move(row));
    }
    return rows;
}

inline double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

}  // namespace tw
