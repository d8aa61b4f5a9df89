#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/report/colours.h"

namespace tw {

/// Rendered pictures of a comparison, one PNG per source, drawn by the same code with the same camera and scale.
struct Pictures {
    std::vector<std::string> free_surface;       ///< last frame from astern; empty where a source has no frames
    std::vector<std::string> hull_pressure;      ///< the bottom seen from below; empty where unknown
    std::string note;                            ///< why there are none, in words
    double pressure_low = 0, pressure_high = 0;  ///< range of the colours [Pa]
};
Pictures render_pictures(const Comparison& comparison, const ColourScale& elevation);

/// Half the range of elevation that the colours cover, the same for all sources [m].
double elevation_half_range(const Comparison& comparison);

/// Map of the mean elevation, one pixel per raster column, y up, mirrored for half models, transparent where there is
/// no free surface.
struct ElevationPicture {
    std::string png;
    double x_min, x_max, y_min, y_max;
};
ElevationPicture elevation_picture(const RunRecord& record, const Analysis& analysis, const ColourScale& scale);

}  // namespace tw
