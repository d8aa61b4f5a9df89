#pragma once
#include <vector>

#include "foam_cases/case_plan.h"

namespace tw {

/// Cells of about `spacing` from `low` to `high`, with the `wanted` planes on cell faces as far as cells stay within 25
/// % of `spacing`: a water block then begins with exactly its volume.
AxisCells split_axis(double low, double high, double spacing, std::vector<double> wanted);

/// Those of an axis of the domain (0 x, 1 y, 2 z), and in its zones cells that grow outwards (scene/mesh/mesh_cells.h). What
/// lies between the zones has the cells that it has without them.
AxisCells axis_with_zones(const Scene& scene, int axis, double cell, const std::vector<double>& wanted);

}  // namespace tw
