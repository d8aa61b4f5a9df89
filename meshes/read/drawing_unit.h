#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace tw {

/// Whether a file's name says that it is a drawing, STEP or IGES, also compressed.
bool is_drawing(const std::filesystem::path& file);

/// The unit of length that a drawing names, in words: "millimetres", "inches"; "units that it does not name" where it
/// names none. STEP (ISO 10303-21): of the entities with LENGTH_UNIT the SI_UNIT or CONVERSION_BASED_UNIT that its
/// context uses, else the first; IGES 5.3: the unit flag, parameter 14 of the global section.
std::string unit_of_step(std::string_view content);
std::string unit_of_iges(std::string_view content);
/// Of the file; throws InputError where it cannot be read.
std::string unit_of_drawing(const std::filesystem::path& file);

}  // namespace tw
