#include "meshes/read/named_solid.h"

#include <algorithm>
#include <vector>

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

void note(std::vector<std::string>& names, const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
}

}  // namespace

NamedSolid named_solid(const fs::path& file) {
    std::error_code none;
    const std::string text = file.string();
    const auto mark = text.rfind('#');
    if (mark == std::string::npos || fs::exists(file, none)) return {file, {}};
    // of a folder called so; what is behind it is a solid's name only if a file stands before it
    if (text.find('/', mark) != std::string::npos && !fs::is_regular_file(text.substr(0, mark), none))
        return {file, {}};
    return {text.substr(0, mark), text.substr(mark + 1)};
}

std::string only_named_in_stl(const fs::path& file, std::string_view content, const std::string& name) {
    std::vector<std::string> there;
    std::string kept, current;
    bool found = false;
    TextCursor text(content);
    for (std::string_view line; text.line(line);) {
        const auto w = words(line);
        const bool opens = !w.empty() && is_word(w[0], "solid"), closes = !w.empty() && is_word(w[0], "endsolid");
        if (opens) current = rest_of(line, w[0]), note(there, current), found |= current == name;
        if (opens || closes || current == name) kept += line;
        kept += '\n';
    }
    if (!found) throw InputError(file.string() + ": " + no_such_solid(name, there));
    return kept;
}

std::string only_named_in_obj(const fs::path& file, std::string_view content, const std::string& name) {
    std::vector<std::string> objects, groups;
    for (TextCursor text(content); !text.rest().empty();) {
        std::string_view line;
        text.line(line);
        const auto w = words(line);
        if (!w.empty() && w[0] == "o") note(objects, rest_of(line, w[0]));
        if (!w.empty() && w[0] == "g") note(groups, rest_of(line, w[0]));
    }
    const bool by_object = !objects.empty();
    const std::vector<std::string>& there = by_object ? objects : groups;
    if (std::ranges::find(there, name) == there.end())
        throw InputError(file.string() + ": " + no_such_solid(name, there));
    std::string kept, current;
    TextCursor text(content);
    for (std::string_view line; text.line(line);) {
        const auto w = words(line);
        if (!w.empty() && w[0] == (by_object ? "o" : "g")) current = rest_of(line, w[0]);
        if (w.empty() || (w[0] != "f" && w[0] != "l") || current == name) kept += line;
        kept += '\n';
    }
    return kept;
}

}  // namespace tw
