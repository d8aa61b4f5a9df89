#pragma once
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "test_paths.h"
#include "text/csv_columns.h"

namespace tw {

/// A table of tests/data.
inline CsvColumns data_table(const std::string& name) { return {read_text(TWINWAKE_TEST_DATA "/" + name), name}; }

/// The rows of one that holds numbers only.
inline std::vector<std::vector<double>> number_rows(const std::string& name) {
    const CsvColumns table = data_table(name);
    std::vector<std::vector<double>> rows(table.rows());
    for (std::size_t c = 0; c < table.headers().size(); ++c)
        for (std::size_t r = 0; r < rows.size(); ++r) rows[r].push_back(table.values(c)[r]);
    return rows;
}

}  // namespace tw
