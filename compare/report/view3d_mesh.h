#pragma once
#include <cstddef>
#include <string>

#include "record/run_record.h"

namespace tw {

/// Surface where the water share of a raster frame is one half, lightly smoothed [m]. Voxels are first averaged in
/// blocks of `coarsening` per edge. A half model's surface is that of its own side, y >= 0, with its edge on y = 0; a
/// two-dimensional run is a slab. Empty where all is wet or all dry.
Surface water_surface(const RunRecord& record, const RasterFrame& frame, int coarsening = 1);

/// A hull with at most `most` triangles, the ones that matter least for its shape left out. Triangles with a corner
/// that is not finite are dropped.
Surface light_surface(const Surface& surface, std::size_t most);

/// Points as base64 of three unsigned 16-bit numbers each, low byte first: 0..65535 for the box's edges. Error at most
/// half a step, box size / 131070.
std::string packed_points(const Surface& surface, const Box& box);
/// Corners of the triangles as base64 of unsigned 16-bit point numbers, low byte first. Throws std::length_error above
/// 65536 points.
std::string packed_triangles(const Surface& surface);

}  // namespace tw
