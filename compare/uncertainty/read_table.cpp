#include "compare/uncertainty/read_table.h"

#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "text/csv_columns.h"

namespace tw {

RefinementTable parse_refinement_table(const std::string& text, const std::string& name) {
    const CsvColumns csv(text, name);
    for (std::size_t c = 0; c < csv.headers().size(); ++c)
        if (csv.headers()[c].empty())
            throw InputError(
                fmt::format("{}: no name of column {} found; expected a name for every column", name, c + 1));
    const auto fail = [&](std::size_t row, const std::string& found, const std::string& expected) {
        throw InputError(fmt::format("{}:{}: {} found; expected {}", name, csv.line(row), found, expected));
    };
    const auto complete = [&](std::size_t c) {
        const std::vector<double>& values = csv.values(c);
        for (std::size_t row = 0; row < values.size(); ++row)
            if (!std::isfinite(values[row]))
                fail(row, "no number in column " + shown_cell(csv.headers()[c]), "one in every row");
        return values;
    };
    RefinementTable table;
    table.spacing_name = csv.headers()[0];
    table.spacing = complete(0);
    for (std::size_t row = 0; row < csv.rows(); ++row) {
        const double h = table.spacing[row];
        if (h <= 0) fail(row, fmt::format("spacing {:g}", h), "a spacing above zero");
        for (std::size_t r = 0; r < row; ++r)
            if (std::abs(table.spacing[r] - h) <= 1e-6 * h)
                fail(row, fmt::format("spacing {:g}, as in line {},", h, csv.line(r)),
                     "a different spacing in every row");
    }
    for (std::size_t c = 1; c < csv.headers().size(); ++c) table.columns.push_back({csv.headers()[c], complete(c)});
    return table;
}

RefinementTable read_refinement_table(const std::filesystem::path& file) {
    return parse_refinement_table(read_text(file), file.string());
}

}  // namespace tw
