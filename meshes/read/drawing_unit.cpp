#include "meshes/read/drawing_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "meshes/read/gzip.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

const char* const not_named = "units that it does not name";

using WordAndName = std::pair<std::string_view, const char*>;
constexpr auto si_prefixes = std::to_array<WordAndName>({{"$", "metres"},
                                                         {"MILLI", "millimetres"},
                                                         {"CENTI", "centimetres"},
                                                         {"DECI", "decimetres"},
                                                         {"KILO", "kilometres"},
                                                         {"MICRO", "micrometres"}});
constexpr auto conversions = std::to_array<WordAndName>({{"INCH", "inches"},
                                                         {"FOOT", "feet"},
                                                         {"FEET", "feet"},
                                                         {"YARD", "yards"},
                                                         {"MILLIMETRE", "millimetres"},
                                                         {"CENTIMETRE", "centimetres"},
                                                         {"METRE", "metres"},
                                                         {"MILE", "miles"}});

/// Upper case, without blanks and line ends outside quotes.
std::string packed_upper(std::string_view text) {
    std::string out;
    bool quoted = false;
    for (const char c : text) {
        if (c == '\'') quoted = !quoted;
        if (quoted || !std::isspace(static_cast<unsigned char>(c)))
            out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return out;
}

/// The entities of a STEP file that have LENGTH_UNIT, one string each: "#12=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(...))".
std::vector<std::string> length_units(std::string_view content) {
    std::vector<std::string> found;
    for (std::size_t at = content.find("LENGTH_UNIT"); at != std::string_view::npos;
         at = content.find("LENGTH_UNIT", at + 1)) {
        const std::size_t before = content.rfind(';', at), end = std::min(content.find(';', at), content.size());
        const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
        if (end - begin < 1000) found.push_back(packed_upper(content.substr(begin, end - begin)));
    }
    return found;
}

std::string unit_named_in(const std::string& entity) {
    if (const std::size_t at = entity.find("CONVERSION_BASED_UNIT("); at != std::string::npos) {
        const std::string_view rest = std::string_view(entity).substr(at);
        for (const auto& [word, name] : conversions)
            if (rest.find(word) != std::string_view::npos) return name;
        return {};
    }
    const std::size_t at = entity.find("SI_UNIT(");
    if (at == std::string::npos || entity.find(".METRE.", at) == std::string::npos) return {};
    for (const auto& [word, name] : si_prefixes)
        if (entity.find(word == "$" ? "SI_UNIT($" : "." + std::string(word) + ".", at) != std::string::npos)
            return name;
    return {};
}

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_packed_drawing(const fs::path& file) { return lowered(file.extension().string()) == ".gz"; }
std::string kind_of_drawing(const fs::path& file) {
    return lowered((is_packed_drawing(file) ? file.stem() : file.filename()).extension().string());
}
bool is_iges(const fs::path& file) { return kind_of_drawing(file) == ".igs" || kind_of_drawing(file) == ".iges"; }

/// The text of the global section: the first 72 columns of the lines with a G in column 73.
std::string global_section(std::string_view content) {
    std::string text;
    while (!content.empty()) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        const std::string_view line = content.substr(0, end);
        if (line.size() > 72 && line[72] == 'G') text += line.substr(0, 72);
        if (line.size() > 72 && line[72] == 'D') break;
        content.remove_prefix(std::min(end + 1, content.size()));
    }
    return text;
}

/// The parameters of a global section; texts are written nHxxx, their first one is the delimiter, the second the end.
std::vector<std::string> parameters_of(const std::string& text) {
    std::vector<std::string> all(1);
    char delimiter = ',', end = ';';
    for (std::size_t at = 0; at < text.size();) {
        std::size_t digits = at;
        while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits]))) ++digits;
        if (digits > at && digits - at < 6 && digits < text.size() && text[digits] == 'H') {
            const auto length = static_cast<std::size_t>(std::stoul(text.substr(at, digits - at)));
            all.back() = text.substr(digits + 1, length);
            at = std::min(digits + 1 + length, text.size());
            if (length == 1 && all.size() == 1) delimiter = all.back()[0];
            if (length == 1 && all.size() == 2) end = all.back()[0];
            continue;
        }
        if (text[at] == delimiter)
            all.emplace_back();
        else if (text[at] == end)
            break;
        else if (text[at] != ' ')
            all.back() += text[at];
        ++at;
    }
    return all;
}

}  // namespace

bool is_drawing(const fs::path& file) {
    return is_iges(file) || kind_of_drawing(file) == ".stp" || kind_of_drawing(file) == ".step";
}

std::string unit_of_step(std::string_view content) {
    const std::vector<std::string> entities = length_units(content);
    std::string first;
    for (const std::string& entity : entities) {
        const std::string name = unit_named_in(entity);
        if (name.empty()) continue;
        if (first.empty()) first = name;
        // A file in inches also has the metre or millimetre from which the inch is converted.
        if (entity.find("CONVERSION_BASED_UNIT(") != std::string::npos) return name;
    }
    return first.empty() ? not_named : first;
}

std::string unit_of_iges(std::string_view content) {
    const std::vector<std::string> parameters = parameters_of(global_section(content));
    constexpr auto flags =
        std::to_array<const char*>({"inches", "millimetres", nullptr, "feet", "miles", "metres", "kilometres", "mils",
                                    "micrometres", "centimetres", "microinches"});
    if (parameters.size() < 14) return not_named;
    const std::string& flag = parameters[13];
    const bool number = !flag.empty() && flag.size() < 3 &&
                        std::ranges::all_of(flag, [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::size_t which = flag.empty() ? 1 : number ? std::stoul(flag) : 0;
    if (which == 3 && parameters.size() > 14) return "the unit \"" + parameters[14].substr(0, 20) + "\"";
    return which >= 1 && which <= flags.size() && flags[which - 1] != nullptr ? flags[which - 1] : not_named;
}

std::string unit_of_drawing(const fs::path& file) {
    std::string content = read_text(file);
    if (is_packed_drawing(file)) content = unpacked(file, content, 200 * content.size() + 1'000'000);
    return is_iges(file) ? unit_of_iges(content) : unit_of_step(content);
}

}  // namespace tw
