#pragma once
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "test_paths.h"

namespace tw {

/// A table of tests/data that holds numbers only: its rows without the head.
inline std::vector<std::vector<double>> number_rows(const std::string& name) {
    std::ifstream file(TWINWAKE_TEST_DATA "/" + name);
    std::vector<std::vector<double>> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::vector<double>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    }
    return rows;
}

}  // namespace tw
