#pragma once
#include <string>

#include "stability/map.h"

namespace tw {

/// A drawn map: colours by what became of the cell, its label, the whole reason when the pointer rests on it. The
/// colours are its own, so that it looks alike in the page, in a dark window and as a file.
struct HeatMap {
    std::string svg;  ///< one <svg> element
    int width = 0, height = 0;
};
HeatMap heat_map(const StabilityMap& map);
const char* colour_of(Stability stability);

}  // namespace tw
