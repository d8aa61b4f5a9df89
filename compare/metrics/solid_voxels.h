#pragma once
#include <cstdint>
#include <vector>

#include "record/raster_grid.h"
#include "record/run_record.h"

namespace tw {

/// Share of each voxel of the record's raster that solids at rest (record/solid_at_rest.h) take, in 255ths as that of
/// water; empty: there are none. Exact in height, along nine vertical lines through each column (one in two dimensions).
std::vector<std::uint8_t> solid_voxels(const RunRecord& record);

}  // namespace tw
