#pragma once
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "test_paths.h"

namespace tw::spray {

/// The columns of a table in tests/data by the names in its first line; nan where a cell says so.
inline std::map<std::string, std::vector<double>> table(const std::string& file) {
    std::ifstream in(std::string(TWINWAKE_TEST_DATA) + "/" + file);
    std::string line, cell;
    std::getline(in, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
    std::map<std::string, std::vector<double>> columns;
    while (std::getline(in, line)) {
        std::istringstream row(line);
        for (const std::string& name : names) {
            std::getline(row, cell, ',');
            columns[name].push_back(std::stod(cell));
        }
    }
    return columns;
}

}  // namespace tw::spray
