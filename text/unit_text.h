#pragma once
#include <string>

namespace tw {

/// A unit as people write it: "m²" of "m2", "kg/m³" of "kg/m3": a 2 or 3 behind a letter that ends its word.
std::string unit_text(const std::string& unit);

}  // namespace tw
