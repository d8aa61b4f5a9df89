#include "meshes/read/named_solid.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "base/errors.h"
#include "meshes/read/text.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

/// What stands behind the first word of a line, without blanks at its ends.
std::string rest_of(std::string_view line, std::string_view first) {
    const char* const end = first.data() + first.size();
    std::string_view rest = line.substr(static_cast<std::size_t>(end - line.data()));
    const auto from = rest.find_first_not_of(" \t");
    if (from == std::string_view::npos) return {};
    return std::string(rest.substr(from, rest.find_last_not_of(" \t") - from + 1));
}

bool is_word(std::string_view a, std::string_view lower) {
    return std::ranges::equal(
        a, lower, [](char x, char y) { return (x >= 'A' && x <= 'Z' ? static_cast<char>(x - 'A' + 'a') : x) == y; });
}

SolidNames names_of(const std::string& name) { return name.empty() ? SolidNames{} : SolidNames{name}; }

/// Which word of an OBJ file names its solids.
std::string_view naming_word(std::string_view content) {
    TextCursor text(content);
    for (std::string_view line; text.line(line);)
        if (const auto w = words(line); !w.empty() && w[0] == "o") return "o";
    return "g";
}

bool is_there(const std::vector<SolidNames>& solids, const std::string& name) {
    return std::ranges::any_of(solids,
                               [&](const SolidNames& names) { return std::ranges::find(names, name) != names.end(); });
}

}  // namespace

NamedSolid named_solid(const fs::path& file) {
    std::error_code none;
    const std::string text = file.string();
    if (fs::exists(file, none)) return {file, {}};
    for (auto mark = text.find('#'); mark != std::string::npos; mark = text.find('#', mark + 1))
        if (fs::is_regular_file(text.substr(0, mark), none)) return {text.substr(0, mark), text.substr(mark + 1)};
    // No such file: the last # is taken for the one before a name, unless it belongs to a folder.
    const auto mark = text.rfind('#');
    if (mark == std::string::npos || text.find('/', mark) != std::string::npos) return {file, {}};
    return {text.substr(0, mark), text.substr(mark + 1)};
}

std::vector<SolidNames> solids_in_stl(std::string_view content) {
    std::vector<SolidNames> solids;
    TextCursor text(content);
    for (std::string_view line; text.line(line);)
        if (const auto w = words(line); !w.empty() && is_word(w[0], "solid"))
            solids.push_back(names_of(rest_of(line, w[0])));
    return solids;
}

std::vector<SolidNames> solids_in_obj(std::string_view content) {
    const std::string_view word = naming_word(content);
    std::vector<SolidNames> solids;
    TextCursor text(content);
    for (std::string_view line; text.line(line);)
        if (const auto w = words(line); !w.empty() && w[0] == word) solids.push_back(names_of(rest_of(line, w[0])));
    return solids;
}

std::string only_named_in_stl(const fs::path& file, std::string_view content, const std::string& name) {
    if (const auto there = solids_in_stl(content); !is_there(there, name))
        throw InputError(file.string() + ": " + no_such_solid(name, there));
    std::string kept, current;
    TextCursor text(content);
    for (std::string_view line; text.line(line);) {
        const auto w = words(line);
        const bool opens = !w.empty() && is_word(w[0], "solid"), closes = !w.empty() && is_word(w[0], "endsolid");
        if (opens) current = rest_of(line, w[0]);
        if (opens || closes || current == name) kept += line;
        kept += '\n';
    }
    return kept;
}

std::string only_named_in_obj(const fs::path& file, std::string_view content, const std::string& name) {
    if (const auto there = solids_in_obj(content); !is_there(there, name))
        throw InputError(file.string() + ": " + no_such_solid(name, there));
    const std::string_view word = naming_word(content);
    std::string kept, current;
    TextCursor text(content);
    for (std::string_view line; text.line(line);) {
        const auto w = words(line);
        if (!w.empty() && w[0] == word) current = rest_of(line, w[0]);
        if (w.empty() || (w[0] != "f" && w[0] != "l") || current == name) kept += line;
        kept += '\n';
    }
    return kept;
}

std::string names_in_words(const std::vector<SolidNames>& solids) {
    std::vector<std::pair<std::string, int>> counted;
    for (const SolidNames& names : solids)
        for (const std::string& name : names | std::views::reverse) {
            const auto found = std::ranges::find(counted, name, &std::pair<std::string, int>::first);
            if (found != counted.end())
                ++found->second;
            else
                counted.emplace_back(name, 1);
        }
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, counted.size()); ++k) {
        const auto& [name, count] = counted[k];
        text += (k > 0 ? ", " : "") + name + (count > 1 ? " (" + std::to_string(count) + " solids)" : "");
    }
    if (counted.size() > most) text += " and " + std::to_string(counted.size() - most) + " more";
    return text;
}

std::string no_such_solid(const std::string& name, const std::vector<SolidNames>& there) {
    const std::string names = names_in_words(there);
    return "no solid in it is called \"" + name + "\"; " +
           (names.empty() ? "it names none: leave #" + name + " out, or name the bodies before the export"
                          : "it has: " + names);
}

}  // namespace tw
