#pragma once
#include "base/numbers.h"
#include "compare/compare.h"
#include "compare/metrics/raster_columns.h"

namespace tw {

/// Splash measures of every raster frame, the same for any source because only the common raster is read. Columns:
///
///   sheet_height [m]   highest connected water (sheet_tops) that is splash, above still water; 0 where none is
///   p95, p99, p99_9 [m]  height above still water below which 95 / 99 / 99.9 % of the airborne water lies
///   airborne_volume [m3], airborne_energy [J] = rho g sum V (z - level)   times the symmetry factor
///   raw_height [m]     highest voxel with a water share of at least 1/100: shown, never judged
///   raised_area [m2]   behind a hull in a stream of three dimensions: water above still water, wave and splash, per
///                      metre of way: volume over the length of the raster behind the hull, times the symmetry factor
///   raised_mean, raised_p90 [m]  height above still water of that water's centre, and that below which 90 % of it lies
///
/// Splash starts above what the wave and the resolution explain: by more than the surface cell of its column
/// (surface_cells(), a voxel or a mesh cell) above the smooth wave, which is nowhere steeper than a gravity wave can be
/// (wave_surface()). Airborne is all water above that, attached or not, in voxels with a share of at least 1/100. Heights p95 to p99_9 are NaN in frames without
/// it. No height is better than half a voxel edge.
Table splash_series(const RunRecord& record, double still_level);

/// z = 0 in a stream. In a tank: where the water of the first frame would stand at rest in what solids leave of the
/// raster.
double still_level(const RunRecord& record);

/// Highest connected water per raster column over all frames from `from` on [m].
std::vector<float> splash_envelope(const RunRecord& record, double from);

/// Width of the Kelvin wake behind the hull [m], from the envelope: crest(x) = max over y behind the transom, level =
/// still level + half the mean crest height; width(x) = distance between the outermost columns that reach the level
/// (twice the half width for a half model); the mean over x. NaN when nothing behind the hull rises above still water
/// by half a voxel edge.
struct WakeWidth {
    double mean = nan;  ///< [m]
    double clipped =
        0;  ///< share of the stations where the outermost column is the raster's [-]: they are wider than seen
};
WakeWidth wake_width(const RunRecord& record, const std::vector<float>& envelope, double still_level);

/// Splash table, elevation map and cuts, envelope of one record.
Analysis analyse(const RunRecord& record);
/// Splash heights, raised and airborne water, envelope and wake width of a comparison whose analyses are filled.
void add_splash(Comparison& comparison, const CompareOptions& options);

/// A value from single frames rather than from a series, known no better than `floor`; `why_not`: where it is no number.
MeanValue value_of_frames(double value, double half_width, double floor, const RunRecord& record,
                          const std::string& why_not);
/// A mean surface or an envelope from less settled time than a mean needs is withheld like one.
void withhold_if_short(MeanValue& value, const Analysis& analysis, const RunRecord& record,
                       const CompareOptions& options);

}  // namespace tw
