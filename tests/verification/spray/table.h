#pragma once
#include <map>

#include "tests/data_table.h"

namespace tw::spray {

/// The columns of a table in tests/data by the names in its first line; NaN where a cell says so.
inline std::map<std::string, std::vector<double>> table(const std::string& file) {
    const CsvColumns csv = data_table(file);
    std::map<std::string, std::vector<double>> columns;
    for (const std::string& name : csv.headers()) columns[name] = csv.values(name);
    return columns;
}

}  // namespace tw::spray
