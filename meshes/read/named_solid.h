#pragma once
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tw {

/// One body of a file that holds several: "boat.obj#keel" is the body that boat.obj calls keel.
struct NamedSolid {
    std::filesystem::path file;
    std::string name;  ///< empty: all that is in the file
};
/// A file whose own name has a # in it is meant where it is there.
NamedSolid named_solid(const std::filesystem::path& file);

/// The text of an ascii STL or an OBJ file in which all facets but those of the solid `name` are blank, so that lines keep
/// their numbers. STL: "solid NAME"; OBJ: "o NAME", or "g NAME" where the file has no objects. Throws InputError with the
/// names that are there.
std::string only_named_in_stl(const std::filesystem::path& file, std::string_view content, const std::string& name);
std::string only_named_in_obj(const std::filesystem::path& file, std::string_view content, const std::string& name);
/// "no solid in it is called X; it has: a, b". Here, because the library that reads drawings says it too.
inline std::string no_such_solid(const std::string& name, const std::vector<std::string>& there) {
    constexpr std::size_t most = 20;
    std::string names;
    for (std::size_t k = 0; k < std::min(most, there.size()); ++k) names += (k > 0 ? ", " : "") + there[k];
    if (there.size() > most) names += " and " + std::to_string(there.size() - most) + " more";
    return "no solid in it is called \"" + name + "\"; " +
           (there.empty() ? "it names none: leave #" + name + " out, or name the bodies before the export"
                          : "it has: " + names);
}

}  // namespace tw
