#pragma once
#include <optional>
#include <string>
#include <vector>

namespace tw {

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
/// By the words of the header, without its unit; letter case does not matter.
SizeColumn size_column(const std::string& header);

/// The spacings that the column means, up to a constant factor (only their ratios count). `dimensions`: 0 where it was
/// not asked for, else 2 or 3. Throws InputError `name:line: ...` of the header's line where the header does not say
/// which, or is unclear. `name_out` becomes the column's name as a spacing: "cells^(-1/3)".
std::vector<double> spacings_of(const std::vector<double>& column, const std::string& header, int dimensions,
                                const std::string& place, std::string& name_out);

}  // namespace tw
