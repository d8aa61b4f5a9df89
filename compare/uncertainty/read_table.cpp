#include "compare/uncertainty/read_table.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "base/atomic_file.h"
#include "base/errors.h"

namespace tw {

namespace {

std::string_view trimmed(std::string_view s) {
    const std::size_t first = s.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? "" : s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

char separator_of(std::string_view header) {
    for (const char c : {'\t', ';'})
        if (header.find(c) != std::string_view::npos) return c;
    return ',';
}

/// Cells of a line without the blanks around them; between quotes a separator is text and "" is one quote.
std::vector<std::string> cells_of(std::string_view line, char separator) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

std::optional<double> number_of(std::string_view cell) {
    if (cell.starts_with('+')) cell.remove_prefix(1);
    double v = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), v);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(v)) return std::nullopt;
    return v;
}

/// Only plain text is quoted in a message, and not all of a long cell.
std::string shown(std::string_view cell) {
    std::string text(cell.substr(0, 40));
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return "'" + text + (cell.size() > 40 ? "...'" : "'");
}

}  // namespace

RefinementTable parse_refinement_table(std::string_view text, const std::string& name) {
    RefinementTable table;
    char separator = 0;
    std::vector<int> line_of_row;
    int number = 0;
    const auto fail = [&](const std::string& found, const std::string& expected) {
        throw InputError(fmt::format("{}:{}: {} found; expected {}", name, number, found, expected));
    };

    const auto read_header = [&](std::string_view line) {
        separator = separator_of(line);
        const std::vector<std::string> names = cells_of(line, separator);
        if (names.size() < 2)
            fail("one column, " + shown(names[0]) + ",",
                 "a header line with a spacing and at least one quantity, such as h,drag");
        for (std::size_t c = 0; c < names.size(); ++c) {
            if (names[c].empty()) fail(fmt::format("no name of column {}", c + 1), "a name for every column");
            if (number_of(names[c])) fail("number " + shown(names[c]), "a header line that names the columns");
        }
        table.spacing_name = names[0];
        for (std::size_t c = 1; c < names.size(); ++c) table.columns.push_back({names[c], {}});
    };

    const auto read_row = [&](std::string_view line) {
        const std::vector<std::string> cells = cells_of(line, separator);
        if (cells.size() != table.columns.size() + 1)
            fail(fmt::format("{} cell{}", cells.size(), cells.size() == 1 ? "" : "s"),
                 fmt::format("{} as in the header line", table.columns.size() + 1));
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::string& column = c == 0 ? table.spacing_name : table.columns[c - 1].name;
            if (cells[c].empty()) fail("nothing in column " + shown(column), "a number");
            const std::optional<double> v = number_of(cells[c]);
            if (!v)
                fail(shown(cells[c]) + " in column " + shown(column),
                     cells[c].find(',') != std::string::npos ? "a finite number with a decimal point, such as 1.5"
                                                             : "a finite number");
            if (c > 0) {
                table.columns[c - 1].values.push_back(*v);
                continue;
            }
            if (*v <= 0) fail("spacing " + cells[0], "a spacing above zero");
            for (std::size_t r = 0; r < table.spacing.size(); ++r)
                if (std::abs(table.spacing[r] - *v) <= 1e-6 * *v)
                    fail(fmt::format("spacing {}, as in line {},", cells[0], line_of_row[r]),
                         "a different spacing in every row");
            table.spacing.push_back(*v);
            line_of_row.push_back(number);
        }
    };

    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
        ++number;
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
        if (table.columns.empty())
            read_header(line);
        else
            read_row(line);
    }
    if (table.columns.empty()) fail("no header line", "one such as h,drag, and a row for every level below it");
    if (table.spacing.empty()) fail("no row below the header line", "a row of numbers for every level");
    return table;
}

RefinementTable read_refinement_table(const std::filesystem::path& file) {
    return parse_refinement_table(read_text(file), file.string());
}

}  // namespace tw
