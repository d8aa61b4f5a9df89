#pragma once
#include <cstddef>
#include <string>

#include "meshes/surface.h"

namespace tw {

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
