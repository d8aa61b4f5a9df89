#include "import/logger_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "base/errors.h"
#include "base/trimmed.h"
#include "text/csv_columns.h"
#include "text/units.h"

namespace tw {
namespace {

using Cells = std::vector<std::string>;

struct Separator {
    const char* name;
    char sign;
};
constexpr std::array<Separator, 4> separators{{{"tab", '\t'}, {"semicolon", ';'}, {"comma", ','}, {"blank", ' '}}};

/// Cells of a line; blanks separate in runs of any length, with tabs among them. Quotes hold separators.
Cells split(std::string_view line, char separator) {
    Cells cells(1);
    bool quoted = false;
    line = trimmed(line);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        const bool parts = separator == ' ' ? c == ' ' || c == '\t' : c == separator;
        if (c == '"')
            quoted = !quoted;
        else if (parts && !quoted)
            separator == ' ' && cells.back().empty() ? void() : void(cells.emplace_back());
        else
            cells.back() += c;
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    if (cells.size() > 1 && cells.back().empty()) cells.pop_back();  // a separator behind the last cell
    return cells;
}
/// The same of a row below names of so many columns: there a separator may stand before an empty last cell.
Cells row_of(std::string_view line, char separator, std::size_t columns) {
    Cells cells = split(line, separator);
    if (cells.size() + 1 == columns && trimmed(line).ends_with(separator)) cells.emplace_back();
    return cells;
}

bool is_number(std::string_view cell, char point) {
    std::string text(cell);
    if (text.starts_with('+')) text.erase(0, 1);
    if (point == ',' && text.find('.') != std::string::npos) return false;
    std::ranges::replace(text, point, '.');
    double v = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

/// "12:01:30.250", with a date before it or not: seconds of its day. "m:s": minutes and seconds.
std::optional<double> seconds_of(std::string_view cell, std::size_t parts) {
    if (const auto date = cell.find_last_of(" T"); date != std::string_view::npos) cell.remove_prefix(date + 1);
    std::string text(cell);
    std::ranges::replace(text, ',', '.');
    double seconds = 0;
    std::size_t found = 0;
    for (const char *at = text.data(), *end = at + text.size(); at <= end; ++found) {
        const char* colon = std::find(at, end, ':');
        double v = 0;
        const auto [stop, error] = std::from_chars(at, colon, v, std::chars_format::fixed);
        const bool whole = std::find(at, colon, '.') == colon;
        if (error != std::errc() || stop != colon || v < 0 || (found > 0 && v >= 60) || (colon != end && !whole))
            return {};
        seconds = 60 * seconds + v;
        at = colon + 1;
    }
    return found == parts ? std::optional(seconds) : std::nullopt;
}

/// "[kN]", "(Nm)" as text/units.h knows them.
std::string bare_unit(std::string_view cell) {
    if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
    return cell == "Nm" || cell == "N-m" ? "N m" : std::string(cell);
}
/// "hh:mm:ss", "HH:MM:SS.fff": how a column of times of day is written; its times become seconds.
bool is_form_of_clock(const std::string& unit) {
    return unit.find(':') != std::string::npos && unit.find_first_not_of("hHmMsSfF:.,") == std::string::npos;
}
bool is_unit(const std::string& cell) {
    const std::string unit = bare_unit(cell);
    if (is_form_of_clock(unit)) return true;
    if (unit == "-") return true;
    try {
        return !unit.empty() && (parse_unit(unit), true);
    } catch (const UnitError&) { return false; }
}

struct Line {
    std::string_view text;
    bool blank = false;  ///< empty, or a comment
};

/// One way to read the text as a table: from the line with the names of its columns to the last row.
struct Reading {
    Separator separator{};
    char point = '.';
    std::size_t columns = 0, first = 0, last = 0;  ///< rows of numbers; lines from 0
    std::optional<std::size_t> names, units;
    bool comma_is_sure = false;  ///< of decimal commas: not what thousands would look like as well
};

std::string as_text(const Reading& r) {
    return fmt::format("{} columns separated by {}s with decimal {}s", r.columns, r.separator.name,
                       r.point == ',' ? "comma" : "point");
}

class Finder {
public:
    Finder(const std::string& text, const std::string& file, const LoggerForm& form) : file_(file), form_(form) {
        std::string_view rest = text;
        if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
        while (!rest.empty()) {
            const std::size_t end = rest.find('\n');
            const std::string_view line = rest.substr(0, end), inner = trimmed(line);
            lines_.push_back({line, inner.empty() || inner.starts_with('#')});
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        }
        clock_parts_ = form.clock == "m:s" ? 2 : 3;
    }

    /// All that make sense, the one of most columns for each separator.
    std::vector<Reading> readings() const {
        std::vector<Reading> found;
        for (const Separator& s : separators)
            for (const char point : {'.', ','}) {
                if (form_.separator != "auto" && form_.separator != s.name) continue;
                if (form_.decimal != "auto" && (form_.decimal == "comma") != (point == ',')) continue;
                if (auto reading = read(s, point)) found.push_back(*reading);
            }
        return found;
    }

    PlainCsv plain(const Reading& r) const {
        PlainCsv out;
        out.clock.assign(r.columns, false);
        std::vector<std::optional<double>> day(r.columns), start(r.columns), before(r.columns);
        std::string names;
        for (std::size_t c = 0; c < r.columns; ++c) {
            const Cells head = r.names ? split(lines_[*r.names].text, r.separator.sign) : Cells();
            names += (c ? "," : "") + quoted(r.names ? head[c] : fmt::format("column {}", c + 1));
        }
        if (r.units)
            for (const std::string& cell : split(lines_[*r.units].text, r.separator.sign))
                out.units.push_back(bare_unit(cell));
        std::vector<double> days(r.columns, 0);
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (k > 0) out.text += '\n';
            if (r.names ? k == *r.names : k + 1 == r.first || (r.first == 0 && k == 0)) {
                out.text += names;
                if (!r.names && r.first == 0) out.text += '\n';  // there is no line for them
                if (r.names || r.first > 0) continue;
            }
            if (k < r.first || lines_[k].blank) {
                out.text += '#';
                continue;
            }
            const Cells cells = row_of(lines_[k].text, r.separator.sign, r.columns);
            for (std::size_t c = 0; c < cells.size(); ++c) {
                out.text += c ? "," : "";
                const auto seconds = form_.clock == "none" ? std::nullopt : seconds_of(cells[c], clock_parts_);
                if (seconds && c < r.columns) {  // past midnight the day's seconds begin anew
                    if (!start[c]) start[c] = *seconds;
                    if (before[c] && *seconds < *before[c] - 43200) days[c] += 86400;
                    before[c] = *seconds, out.clock[c] = true;
                    out.text += fmt::format("{:.9g}", *seconds + days[c] - *start[c]);
                } else if (r.point == ',' && is_number(cells[c], ',')) {
                    std::string number = cells[c];
                    std::ranges::replace(number, ',', '.');
                    out.text += number;
                } else
                    out.text += quoted(cells[c]);
            }
        }
        return out;
    }

    /// Whether text/csv_columns.h reads the text in the same way as it stands.
    bool is_plain(const Reading& r) const {
        if (r.point == ',' || r.units || !r.names || above(*r.names) || above(r.first) != r.names) return false;
        return r.separator.sign == separator_of(lines_[*r.names].text) && !has_clock(r);
    }
    /// Throws where a line among the rows has another number of cells. One with as many is for whoever reads its cells.
    void refuse_odd_lines(const Reading& r) const {
        for (std::size_t k = r.first; k < lines_.size(); ++k) {
            const std::size_t cells = row_of(lines_[k].text, r.separator.sign, r.columns).size();
            if (!lines_[k].blank && cells != r.columns)
                throw InputError(fmt::format(
                    "{}:{}: {}, {} cell{}, found below line {}, where the table begins, of {}; expected a row of as "
                    "many cells (# before a line leaves it out)",
                    file_, k + 1, shown_cell(trimmed(lines_[k].text)), cells, cells == 1 ? "" : "s", r.first + 1,
                    as_text(r)));
        }
    }

    [[noreturn]] void fail(const char* key, const std::string& what) const {
        const auto place = form_.place.find(key);
        throw InputError((place == form_.place.end() ? file_ : place->second) + ": " + what);
    }

private:
    static std::string quoted(const std::string& cell) {
        if (cell.find_first_of(",\"#") == std::string::npos) return cell;
        std::string out = "\"";
        for (const char c : cell) out += c == '"' ? "\"\"" : std::string(1, c);
        return out + "\"";
    }
    bool is_value(const std::string& cell, char point) const {
        return is_number(cell, point) || (form_.clock != "none" && seconds_of(cell, clock_parts_));
    }
    /// A row of the table: a number or a time, and no fewer of them than words.
    bool is_row(const Cells& cells, std::size_t columns, char point) const {
        const auto values = std::ranges::count_if(cells, [&](const std::string& c) { return is_value(c, point); });
        const auto words =
            std::ranges::count_if(cells, [&](const std::string& c) { return !c.empty() && !is_value(c, point); });
        return cells.size() == columns && (values == 0 ? words == 0 : values >= words);
    }
    bool is_head(std::size_t k, const Reading& r) const {
        const Cells cells = split(lines_[k].text, r.separator.sign);
        return !lines_[k].blank && cells.size() == r.columns &&
               std::ranges::none_of(cells, [&](const std::string& c) { return is_value(c, r.point); });
    }
    bool has_clock(const Reading& r) const {
        const Cells cells = split(lines_[r.last].text, r.separator.sign);
        return form_.clock != "none" && std::ranges::any_of(cells, [&](const std::string& c) {
                   return seconds_of(c, clock_parts_).has_value();
               });
    }
    /// The line above that is no comment; nothing at the top.
    std::optional<std::size_t> above(std::size_t k) const {
        while (k-- > 0)
            if (!lines_[k].blank) return k;
        return {};
    }

    /// Of each cell of a row whether it is a value, a word or empty: "vwe". Nothing of what is no row.
    std::string form_of(const Cells& cells, char point) const {
        if (cells.size() < 2 || !is_row(cells, cells.size(), point)) return {};
        std::string form;
        for (const std::string& cell : cells) form += cell.empty() ? 'e' : is_value(cell, point) ? 'v' : 'w';
        return form;
    }
    /// Whether a row is of this form; an empty cell fits any.
    static bool fits(const std::string& row, const std::string& form) {
        return std::ranges::equal(row, form, [](char a, char b) { return a == b || a == 'e' || b == 'e'; });
    }

    /// The table is what the rows of one form are that hold the most numbers: it begins with the first of them, and with
    /// rows of as many cells right above that. What stands among them does not end it.
    std::optional<Reading> read(const Separator& separator, char point) const {
        const std::size_t top = form_.header_line ? static_cast<std::size_t>(*form_.header_line) : 0;
        const auto form_in = [&](std::size_t k, std::size_t columns) {
            return lines_[k].blank ? "" : form_of(row_of(lines_[k].text, separator.sign, columns), point);
        };
        Reading r;
        r.separator = separator, r.point = point;
        std::map<std::size_t, std::ptrdiff_t> by_columns;  // numbers in the rows of so many cells
        for (std::size_t k = top; k < lines_.size(); ++k) {
            const std::string form = form_in(k, 0);
            const auto values = std::ranges::count(form, 'v');
            if (values < 2) continue;  // a time and a quantity
            by_columns[form.size()] += values;
            if (trimmed(lines_[k].text).ends_with(separator.sign)) by_columns[form.size() + 1] += values;
        }
        if (by_columns.empty()) return {};
        const auto numbers = [](const auto& rows) { return rows.second; };
        r.columns = std::ranges::max_element(by_columns, {}, numbers)->first;
        std::map<std::string, std::ptrdiff_t> by_form;
        for (std::size_t k = top; k < lines_.size(); ++k)
            if (const std::string form = form_in(k, r.columns); form.size() == r.columns)
                by_form[form] += std::ranges::count(form, 'v');
        const std::string usual = std::ranges::max_element(by_form, {}, numbers)->first;
        r.first = top;
        while (!fits(form_in(r.first, r.columns), usual)) ++r.first;
        r.last = r.first;
        for (std::size_t k = r.first + 1; k < lines_.size(); ++k)
            if (form_in(k, r.columns).size() == r.columns) r.last = k;
        for (auto k = above(r.first); k && *k >= top && form_in(*k, r.columns).size() == r.columns; k = above(*k))
            r.first = *k;
        if (point == ',' && !has_decimal_commas(r)) return {};
        find_names(r);
        return r;
    }

    /// Whether a cell of the table has a decimal comma; sure where one cannot be a separator of thousands.
    bool has_decimal_commas(Reading& r) const {
        bool any = false;
        for (std::size_t k = r.first; k <= r.last; ++k) {
            if (lines_[k].blank) continue;
            for (const std::string& cell : split(lines_[k].text, r.separator.sign)) {
                const auto comma = cell.find(',');
                if (comma == std::string::npos || !is_number(cell, ',')) continue;
                any = true;
                const auto before = cell.find_first_of("123456789");
                const bool thousands = cell.size() == comma + 4 && before < comma && comma - before <= 3;
                r.comma_is_sure = r.comma_is_sure || !thousands;
            }
        }
        return any;
    }

    void find_names(Reading& r) const {
        if (form_.header_line && *form_.header_line == 0) return;
        auto k = above(r.first);
        if (form_.header_line) {
            const auto given = static_cast<std::size_t>(*form_.header_line) - 1;
            if (given < lines_.size() && split(lines_[given].text, r.separator.sign).size() == r.columns)
                r.names = given;
            if (k && r.names && *k > *r.names && form_.units_row.value_or(is_units(*k, r))) r.units = k;
            return;
        }
        if (!k || !is_head(*k, r)) return;
        const auto higher = above(*k);
        if (higher && is_head(*higher, r) && form_.units_row.value_or(is_units(*k, r)))
            r.units = k, r.names = higher;
        else
            r.names = k;
    }
    bool is_units(std::size_t k, const Reading& r) const {
        const Cells cells = split(lines_[k].text, r.separator.sign);
        return cells.size() == r.columns &&
               std::ranges::all_of(cells, [](const std::string& c) { return c.empty() || is_unit(c); });
    }

    const std::string& file_;
    const LoggerForm& form_;
    std::vector<Line> lines_;
    std::size_t clock_parts_ = 3;
};

}  // namespace

PlainCsv plain_csv(const std::string& text, const std::string& file, const LoggerForm& form) {
    const Finder finder(text, file, form);
    std::vector<Reading> found = finder.readings();
    if (form.header_line != 0) std::erase_if(found, [](const Reading& r) { return !r.names; });
    // Blanks stand beside other separators, too; and commas that are numbers' are not read by a decimal point.
    if (std::ranges::any_of(found, [](const Reading& r) { return r.separator.sign != ' '; }))
        std::erase_if(found, [](const Reading& r) { return r.separator.sign == ' '; });
    const auto same_cells = [](const Reading& a, const Reading& b) { return a.separator.sign == b.separator.sign; };
    for (std::size_t k = 0; k + 1 < found.size(); ++k)
        if (same_cells(found[k], found[k + 1]) && found[k + 1].first <= found[k].first && found[k + 1].comma_is_sure)
            found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
    if (found.empty()) {
        if (form.place.empty()) return {text, {}, {}};
        finder.fail(
            form.place.begin()->first.c_str(),
            fmt::format("no table was found in {} that has rows of at least two columns and fits what is said "
                        "of it here; expected other values of separator, decimal, header_line, units_row, clock",
                        file));
    }
    if (found.size() > 1) {
        const bool points = same_cells(found[0], found[1]);
        finder.fail(
            points ? "decimal" : "separator",
            fmt::format("can be read as {} and as {}; expected {} in the mapping", as_text(found[0]), as_text(found[1]),
                        points ? "decimal = \"comma\" or \"point\""
                               : fmt::format("separator = \"{}\" or \"{}\"", found[0].separator.name,
                                             found[1].separator.name)));
    }
    const Reading& r = found.front();
    if (r.point == ',' && !r.comma_is_sure && form.decimal == "auto")
        finder.fail("decimal",
                    "its numbers, such as 1,234, may have a decimal comma or one of thousands; expected decimal "
                    "= \"comma\" in the mapping, or a file without separators of thousands");
    finder.refuse_odd_lines(r);
    return finder.is_plain(r) ? PlainCsv{text, {}, {}} : finder.plain(r);
}

}  // namespace tw
