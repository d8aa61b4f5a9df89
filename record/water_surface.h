#pragma once
#include "record/run_record.h"

namespace tw {

/// Surface where the water share of a raster frame is one half, lightly smoothed [m]. Voxels are first averaged in
/// blocks of `coarsening` per edge. A half model's surface is that of its own side, y >= 0, with its edge on y = 0; a
/// two-dimensional run is a slab. Empty where all is wet or all dry.
Surface water_surface(const RunRecord& record, const RasterFrame& frame, int coarsening = 1);

}  // namespace tw
