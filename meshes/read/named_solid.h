#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tw {

/// One body of a file that holds several: "boat.step#keel" is the body that boat.step calls keel.
struct NamedSolid {
    std::filesystem::path file;
    std::string name;  ///< empty: all that is in the file
};
/// A file whose own name has a # in it is meant where it is there.
NamedSolid named_solid(const std::filesystem::path& file);

/// What a file calls one of its solids: by itself, its part, the place of the part in an assembly, that assembly, and
/// so on outwards. No name twice; none at all where the file has none for it.
using SolidNames = std::vector<std::string>;

/// Of the solids of an OBJ file ("o NAME", or "g NAME" where the file has no objects) or of an ascii STL ("solid
/// NAME"), in their order.
std::vector<SolidNames> solids_in_obj(std::string_view content);
std::vector<SolidNames> solids_in_stl(std::string_view content);

/// The text of such a file in which all facets but those of the solids `name` are blank, so that lines keep their
/// numbers. Throws InputError with the names that are there.
std::string only_named_in_stl(const std::filesystem::path& file, std::string_view content, const std::string& name);
std::string only_named_in_obj(const std::filesystem::path& file, std::string_view content, const std::string& name);

/// "boat (3 solids), keel, post (2 solids)": the outermost name of each solid first.
std::string names_in_words(const std::vector<SolidNames>& solids);
/// "no solid in it is called X; it has: a, b".
std::string no_such_solid(const std::string& name, const std::vector<SolidNames>& there);

}  // namespace tw
