#pragma once
#include <cstdint>
#include <vector>

#include "record/raster_grid.h"
#include "record/run_record.h"

namespace tw {

// Water shares of a voxel, in 255ths.
inline constexpr std::uint8_t half_full = 128;  ///< the first that is at least one half
/// The first of at least 1/100: what counts as water above the wave. A mesh smears less than that over the cells along a
/// hull, high above a calm surface.
inline constexpr std::uint8_t least_share = 3;

/// Share of each voxel of the record's raster that solids at rest (record/solid_at_rest.h) take, in 255ths as that of
/// water; empty: there are none. Exact in height, along nine vertical lines through each column (one in two dimensions).
using SolidVoxels = std::vector<std::uint8_t>;
SolidVoxels solid_voxels(const RunRecord& record);

/// 1 for each voxel of the main water body: water in at least half of what solids leave of it, in the largest set
/// connected through faces, edges or corners (26 neighbours).
std::vector<std::uint8_t> main_body(const RasterGrid& grid, const RasterFrame& frame, const SolidVoxels& solid = {});

/// Per column the top of the highest water of the main body [m]: lower face of its voxel + share x edge, on what is solid
/// in it. NaN where there is none.
std::vector<float> sheet_tops(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body,
                              const SolidVoxels& solid = {});

/// Per column the height of its connected water [m]: raster floor + edge x sum of shares over the main body, over the
/// part-filled voxels that touch it from above, and over solids below it. A hollow counts as missing height. NaN where
/// there is none, and where a solid lies on the water: its surface is not free there.
std::vector<float> elevations(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body,
                              const SolidVoxels& solid = {});

/// 1 for each column whose centre lies in the hull's plan view (both sides of y = 0).
std::vector<std::uint8_t> under_hull(const RasterGrid& grid, const Surface& hull);

}  // namespace tw
