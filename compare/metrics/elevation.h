#pragma once
#include "compare/compare.h"

namespace tw {

/// Free-surface elevation per raster column, mean over the frames from `from` on (the last frame where there is none)
/// [m]: column integral of the connected water (elevations()). Columns under the hull's plan view are NaN: their
/// surface is not free. `deviation`: standard deviation over time.
struct ElevationMap {
    std::vector<float> mean, deviation;  ///< [m], one for each raster column, x fastest
    std::size_t frames = 0;
};
ElevationMap mean_elevation(const RunRecord& record, double from);

/// The map along the record's cuts (numbers cut_x_0.., cut_y_0..), linear between column centres; of a tank without any
/// along x in its middle.
std::vector<Cut> elevation_cuts(const RunRecord& record, const ElevationMap& map);

/// Highest and lowest point of a cut with the standard error of its mean elevation [m]; NaN when the cut holds no
/// value.
struct Extreme {
    double value, deviation, position;  ///< [m]
};
Extreme crest(const Cut& cut);
Extreme trough(const Cut& cut);

/// Root mean square of B - A over the positions both know, linear in between [m]; NaN when they share none.
double rms_difference(const Cut& a, const Cut& b);

/// crest_y_PLACE, trough_y_PLACE, crest_x_PLACE, trough_x_PLACE [m] of a comparison whose analyses are filled: the
/// highest and lowest point of each cut that the first source with cuts has.
void add_elevation(Comparison& comparison, const CompareOptions& options);

}  // namespace tw
