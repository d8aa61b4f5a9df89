#include "compare/uncertainty/size_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/errors.h"
#include "text/csv_columns.h"
#include "text/units.h"

namespace tw {

namespace {

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

}  // namespace

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

}  // namespace tw
