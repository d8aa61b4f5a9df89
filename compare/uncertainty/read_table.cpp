#include "compare/uncertainty/read_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/numbers.h"
#include "compare/uncertainty/size_column.h"
#include "text/csv_columns.h"

namespace tw {

namespace {

/// The unit of the last place of a number as written: 0.001 of "1.250", 100 of "1.2e3"; 1 of a whole number.
double last_place(std::string_view cell) {
    const std::size_t e = cell.find_first_of("eE"), dot = cell.substr(0, e).find('.');
    int exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view text = cell.substr(e + 1);
        if (text.starts_with('+')) text.remove_prefix(1);
        std::from_chars(text.data(), text.data() + text.size(), exponent);
    }
    const std::size_t end = std::min(e, cell.size());
    const auto decimals = dot == std::string_view::npos ? 0 : static_cast<int>(end - dot) - 1;
    return std::pow(10.0, exponent - decimals);
}

double last_place(const std::vector<std::string>& cells) {
    double least = infinite;
    for (const std::string& cell : cells) least = std::min(least, last_place(cell));
    return least;
}

}  // namespace

RefinementTable parse_refinement_table(const std::string& text, const std::string& name, int dimensions) {
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
    const std::vector<double> sizes = complete(0);
    const SizeMeasure measure = size_column(csv.headers()[0]).measure;
    const char* const what = measure == SizeMeasure::spacing ? "spacing" : "size";
    for (std::size_t row = 0; row < csv.rows(); ++row) {
        const double h = sizes[row];
        if (h <= 0) fail(row, fmt::format("{} {:g}", what, h), fmt::format("a {} above zero", what));
        for (std::size_t r = 0; r < row; ++r)
            if (std::abs(sizes[r] - h) <= 1e-6 * h)
                fail(row, fmt::format("{} {:g}, as in line {},", what, h, csv.line(r)),
                     fmt::format("a different {} in every row", what));
    }
    table.spacing = spacings_of(sizes, csv.headers()[0], dimensions, fmt::format("{}:{}", name, csv.header_line()),
                                table.spacing_name);
    for (std::size_t c = 1; c < csv.headers().size(); ++c)
        table.columns.push_back({csv.headers()[c], complete(c), 0.5 * last_place(csv.texts(c))});
    return table;
}

RefinementTable read_refinement_table(const std::filesystem::path& file, int dimensions) {
    return parse_refinement_table(read_text(file), file.string(), dimensions);
}

}  // namespace tw
