#pragma once
// Reference tables of tests/data as rows by column name.
#include <map>

#include "tests/data_table.h"

namespace tw {

/// One row of a table: column name -> what stands there.
using Row = std::map<std::string, std::string>;

inline std::vector<Row> table_of(const std::string& file) {
    const CsvColumns csv = data_table(file);
    std::vector<Row> rows(csv.rows());
    for (const std::string& name : csv.headers()) {
        const std::vector<std::string> cells = csv.texts(name);
        for (std::size_t r = 0; r < rows.size(); ++r) rows[r][name] = cells[r];
    }
    return rows;
}

inline double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

}  // namespace tw
