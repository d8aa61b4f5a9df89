#include "csv.h"

#include <algorithm>
#include <stdexcept>

#include "base/atomic_file.h"
#include "text/csv_columns.h"

namespace tw::test {
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
    const CsvColumns table(read_text(file), file.string());
    Csv csv{table.headers(), std::vector<std::vector<std::string>>(table.rows())};
    for (const std::string& name : csv.names) {
        const std::vector<std::string> cells = table.texts(name);
        for (std::size_t r = 0; r < cells.size(); ++r) csv.rows[r].push_back(cells[r]);
    }
    return csv;
}

}  // namespace tw::test
