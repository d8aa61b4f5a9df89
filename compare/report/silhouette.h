#pragma once
#include <array>

#include "compare/report/svg_plot.h"
#include "meshes/surface.h"

namespace tw {

/// What a surface hides, seen from the side (`up` 2, z over x) or from above (`up` 1, y over x): at each x, `step` [m]
/// apart from `shown[0]` to `shown[1]`, the union of what its triangles cover there.
PlotShadow silhouette(const Surface& surface, int up, double step, const std::array<double, 2>& shown);

}  // namespace tw
