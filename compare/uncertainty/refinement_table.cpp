#include "compare/uncertainty/refinement_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/numbers.h"
#include "text/csv_columns.h"
#include "text/units.h"

namespace tw {

namespace {

/// What the first column of a refinement table measures, by its header.
enum class SizeMeasure {
    spacing,     ///< "h [m]", "dp", "cell size": as it is
    count,       ///< "cells", "number of particles", "N": h = N^(-1/d), d the number of dimensions that are refined
    per_length,  ///< "cells per beam", "D/dp", "1/h": h = 1/x
    unclear      ///< "grid", "level", "run": a number of a row, or a word that may mean either
};

struct SizeColumn {
    SizeMeasure measure = SizeMeasure::spacing;
    bool known = false;             ///< whether the header has a word for it; a spacing is assumed where it has none
    std::optional<int> dimensions;  ///< 2 or 3, where the header says so: "cells (2d)"
};

using HeaderWords = std::vector<std::string>;

constexpr auto counted_words = std::to_array<std::string_view>(
    {"cell",    "particle", "element", "node",  "point", "vertex",    "vertice",  "volume",
     "unknown", "dof",      "elem",    "part",  "ncell", "nparticle", "nelement", "nnode",
     "npoint",  "ncv",      "nel",     "nelem", "npart", "gridpoint"});
constexpr auto counting_words = std::to_array<std::string_view>(
    {"n", "np", "nc", "count", "number", "num", "no", "nr", "total", "million", "mio", "thousand"});
constexpr auto spacing_words = std::to_array<std::string_view>(
    {"h",      "dp",       "dx",    "dy",     "dz",   "ds",      "dr",      "δx",    "Δx",
     "δ",      "Δ",        "delta", "deltax", "lc",   "spacing", "size",    "width", "edge",
     "length", "distance", "step",  "pitch",  "hull", "voxel",   "diameter"});
constexpr auto unclear_words =
    std::to_array<std::string_view>({"grid", "mesh", "level", "run", "case", "id", "index", "row", "study",
                                     "refinement", "resolution", "ratio", "factor", "r", "name", "density"});

/// Lower case, plural s taken off; parts of "near_hull" and "cell-size" are words of their own.
HeaderWords header_words(const std::string& text) {
    HeaderWords words;
    std::string word;
    const auto end = [&] {
        if (word.size() > 3 && word.ends_with('s') && !word.ends_with("ss")) word.pop_back();
        if (!word.empty()) words.push_back(word);
        word.clear();
    };
    for (const char c : text) {
        if (c >= 'A' && c <= 'Z')
            word += static_cast<char>(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80)
            word += c;
        else {
            end();
            if (c == '/') words.emplace_back("/");
            if (c == '#') words.emplace_back("number");
        }
    }
    end();
    return words;
}

template <class List>
bool any_in(const HeaderWords& words, const List& list) {
    return std::ranges::any_of(words, [&](const std::string& w) { return std::ranges::find(list, w) != list.end(); });
}

/// The header without what stands in brackets, which is a unit or a number of dimensions.
std::string without_brackets(const std::string& header) {
    std::string out;
    int depth = 0;
    for (const char c : header) {
        if (c == '[' || c == '(') ++depth;
        if (depth == 0) out += c;
        if ((c == ']' || c == ')') && depth > 0) --depth;
    }
    return out;
}

std::optional<int> dimensions_in(const std::string& header) {
    const HeaderWords words = header_words(header);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (const int d : {2, 3}) {
            const std::string digit = std::to_string(d);
            const bool apart =
                words[i] == digit && i + 1 < words.size() && (words[i + 1] == "d" || words[i + 1].starts_with("dim"));
            if (apart || words[i] == digit + "d" || words[i] == digit + "dim") return d;
        }
    return std::nullopt;
}

/// "cells per beam", "N/L", "D/dp", "1/h": parts of something that grow in number as they become finer; "h/D" is not.
bool is_per_length(const HeaderWords& words) {
    if (any_in(words, std::to_array<std::string_view>({"per", "across"}))) return true;
    const auto slash = std::ranges::find(words, "/");
    const HeaderWords before(words.begin(), slash), after(slash == words.end() ? slash : slash + 1, words.end());
    if (before.empty() || after.empty()) return false;
    if (any_in(before, spacing_words)) return false;
    return any_in(before, counted_words) || any_in(before, counting_words) || any_in(after, spacing_words);
}

/// "grid [m]", "resolution (mm)", "resolution_mm": a word that may mean either with a unit of length.
bool has_unit_of_length(const std::string& header, const HeaderWords& words) {
    if (any_in(words, std::to_array<std::string_view>({"m", "mm", "cm", "um", "ft", "in"}))) return true;
    const std::size_t open = header.find_first_of("[("), close = header.find_first_of("])", open);
    if (open == std::string::npos || close == std::string::npos) return false;
    try {
        return parse_unit(header.substr(open + 1, close - open - 1)).dimension == parse_unit("m").dimension;
    } catch (const UnitError&) { return false; }
}

/// By the words of the header, without its unit; letter case does not matter.
SizeColumn size_column(const std::string& header) {
    SizeColumn column;
    column.dimensions = dimensions_in(header);
    HeaderWords words = header_words(without_brackets(header));
    if (words.empty()) words = header_words(header);
    std::erase_if(words, [](const std::string& w) { return w == "2d" || w == "3d"; });
    const bool of_length = any_in(words, spacing_words),
               of_count = any_in(words, counted_words) || any_in(words, counting_words);
    column.known = true;
    if (is_per_length(words))
        column.measure = SizeMeasure::per_length;
    else if (of_length)  // "cell size", "particle spacing", "mesh size"
        column.measure = SizeMeasure::spacing;
    else if (of_count)  // "cells", "grid points", "number of elements"
        column.measure = SizeMeasure::count;
    else if (has_unit_of_length(header, words))
        column.measure = SizeMeasure::spacing;
    else if (any_in(words, unclear_words))
        column.measure = SizeMeasure::unclear;
    else
        column.known = false;
    return column;
}

/// The spacings that the column means, up to a constant factor (only their ratios count). `dimensions`: 0 where it was
/// not asked for, else 2 or 3. Throws InputError `name:line: ...` of the header's line where the header does not say
/// which, or is unclear. `name_out` becomes the column's name as a spacing: "cells^(-1/3)".
std::vector<double> spacings_of(const std::vector<double>& column, const std::string& header, int dimensions,
                                const std::string& place, std::string& name_out) {
    SizeColumn c = size_column(header);
    name_out = header;
    const bool like_counts = std::ranges::all_of(column, [](double x) { return x >= 50 && x == std::floor(x); });
    if (!c.known && like_counts && column.size() > 1) c.measure = SizeMeasure::unclear;
    std::vector<double> h = column;
    if (c.measure == SizeMeasure::unclear)
        throw InputError(fmt::format(
            "{}: first column {} found; it may be a spacing, a count or a number of the row. Expected a name "
            "that says which: a spacing (h, dp, cell size), a count (cells, particles, elements, nodes) or "
            "a number per length (cells per beam)",
            place, shown_cell(header)));
    if (c.measure == SizeMeasure::spacing) return h;
    if (c.measure == SizeMeasure::per_length) {
        for (double& x : h) x = 1 / x;
        name_out = "1/(" + header + ")";
        return h;
    }
    const int d = dimensions != 0 ? dimensions : c.dimensions.value_or(0);
    if (d == 0)
        throw InputError(fmt::format(
            "{}: first column {} found, a count and no spacing; the spacing is N^(-1/d), and d is not said: "
            "give --dimensions 2 or 3, or write it into the header, as in \"cells (3d)\"",
            place, shown_cell(header)));
    for (double& x : h) x = std::pow(x, -1.0 / d);
    name_out = fmt::format("({})^(-1/{})", header, d);
    return h;
}

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
