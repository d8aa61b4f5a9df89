#include "text/csv_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/numbers.h"
#include "base/trimmed.h"

namespace tw {
namespace {

struct Cell {
    std::string text;
    int column = 1;  ///< of its first character in the line, from 1
};

std::vector<Cell> cells_of(std::string_view line, char separator) {
    std::vector<Cell> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
            cells.back().text += line[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            cells.push_back({"", static_cast<int>(i) + 2});
        else
            cells.back().text += c;
    }
    for (Cell& cell : cells) {
        const std::string_view inner = trimmed(cell.text);
        const auto blanks = std::min(cell.text.find_first_not_of(" \t"), cell.text.size());
        if (!inner.empty()) cell.column += static_cast<int>(blanks);
        cell.text = inner;
    }
    return cells;
}

/// NaN for an empty cell or the word NaN; nothing for what is no finite number.
std::optional<double> number_of(std::string_view cell) {
    const auto is = [](char c, char lower) { return c == lower || c == lower - 'a' + 'A'; };
    if (cell.empty() || (cell.size() == 3 && is(cell[0], 'n') && is(cell[1], 'a') && is(cell[2], 'n'))) return nan;
    if (cell.starts_with('+')) cell.remove_prefix(1);
    double v = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), v);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(v)) return std::nullopt;
    return v;
}

}  // namespace

char separator_of(std::string_view header) {
    bool quoted = false, semicolon = false;
    for (const char c : header) {
        if (c == '"') quoted = !quoted;
        if (c == '\t' && !quoted) return c;
        semicolon = semicolon || (c == ';' && !quoted);
    }
    return semicolon ? ';' : ',';
}

std::string shown_cell(std::string_view cell) {
    std::string text(cell.substr(0, 60));
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return "\"" + text + (cell.size() > 60 ? "...\"" : "\"");
}

CsvColumns::CsvColumns(std::string whole, std::string file) : text_(std::move(whole)), file_(std::move(file)) {
    std::string_view text = text_;
    if (text.empty()) throw InputError(file_ + ":1: an empty file found; expected a header line and rows of numbers");
    if (text.find('\0') != std::string_view::npos || text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError(file_ + ":1: binary data or UTF-16 found; expected plain text (save it as CSV, UTF-8)");
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    int number = 0;
    while (!text.empty()) {
        ++number;
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
        if (headers_.empty())
            read_header(line, number);
        else
            read_row(line, number);
    }
    if (headers_.empty())
        throw InputError(fmt::format("{}:{}: no header line found; expected one such as t,Drag,Lift", file_, number));
    if (line_.empty())
        throw InputError(fmt::format("{}:{}: no row found below the header line; expected numbers", file_, number));
}

void CsvColumns::read_header(std::string_view line, int number) {
    header_line_ = number;
    separator_ = separator_of(line);
    std::vector<Cell> cells = cells_of(line, separator_);
    if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
    if (cells.size() < 2)
        throw InputError(
            fmt::format("{}:{}: one column, {}, found; expected a header line with a time and at least "
                        "one quantity, separated by commas, semicolons or tabs",
                        file_, number, shown_cell(cells[0].text)));
    if (std::ranges::all_of(cells, [](const Cell& c) { return number_of(c.text).has_value(); }))
        throw InputError(
            fmt::format("{}:{}: a line of numbers found; expected a header line that names the columns, "
                        "without # before it",
                        file_, number));
    for (Cell& cell : cells) headers_.push_back(std::move(cell.text));
    values_.resize(headers_.size());
    first_fault_.resize(headers_.size());
}

void CsvColumns::read_row(std::string_view line, int number) {
    std::vector<Cell> cells = cells_of(line, separator_);
    if (cells.size() == headers_.size() + 1 && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != headers_.size())
        throw InputError(fmt::format("{}:{}: {} cell{} found; expected {} as in the header line (line {}: {})", file_,
                                     number, cells.size(), cells.size() == 1 ? "" : "s", headers_.size(), header_line_,
                                     header_list()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::optional<double> v = number_of(cells[c].text);
        values_[c].push_back(v.value_or(std::numeric_limits<double>::quiet_NaN()));
        if (!v && !first_fault_[c]) first_fault_[c] = Fault{number, cells[c].column, cells[c].text};
    }
    line_.push_back(number);
    rows_.push_back(line);
}

std::size_t CsvColumns::column(std::string_view header) const {
    const std::vector<std::size_t> found = find(header);
    if (found.size() != 1)
        throw InputError(fmt::format("{}: {} column {} found; expected one; it has: {}", file_,
                                     found.empty() ? "no" : "more than one", shown_cell(header), header_list()));
    return found.front();
}

std::vector<std::string> CsvColumns::texts(std::size_t column) const {
    std::vector<std::string> cells;
    for (const std::string_view row : rows_) cells.push_back(cells_of(row, separator_)[column].text);
    return cells;
}

const std::vector<double>& CsvColumns::values(std::size_t column) const {
    if (const auto& fault = first_fault_[column])
        throw InputError(fmt::format("{}:{}:{}: {} found in column {}; expected {}", file_, fault->line, fault->column,
                                     shown_cell(fault->cell), shown_cell(headers_[column]),
                                     fault->cell.find(',') != std::string::npos
                                         ? "a finite number with a decimal point, such as 1.5"
                                         : "a finite number, or nothing where there is none"));
    return values_[column];
}

std::vector<std::size_t> CsvColumns::find(std::string_view header) const {
    std::vector<std::size_t> found;
    for (std::size_t c = 0; c < headers_.size(); ++c)
        if (headers_[c] == header) found.push_back(c);
    return found;
}

std::string CsvColumns::header_list() const {
    std::string list;
    for (const std::string& h : headers_) {
        if (list.size() > 1000) return list + ", ...";
        list += (list.empty() ? "" : ", ") + shown_cell(h);
    }
    return list;
}

}  // namespace tw
