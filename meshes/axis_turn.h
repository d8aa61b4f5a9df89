#pragma once
#include <Eigen/Core>
#include <string_view>

#include "meshes/surface.h"

namespace tw {

/// Rows: a file's axis that becomes x, y, z, with its sign: "xyz", "x-zy" (file with y up), "-x-yz" (bow towards +x in
/// the file). May be a mirroring: its determinant is 1 or -1. Throws InputError for anything else.
Eigen::Matrix3d axis_turn(std::string_view axes);

/// The surface in these axes, its triangles outwards still where the turn is a mirroring.
void turn_axes(Surface& surface, const Eigen::Matrix3d& turn);

}  // namespace tw
