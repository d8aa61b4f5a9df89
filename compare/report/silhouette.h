#pragma once
#include "compare/report/svg_plot.h"
#include "meshes/surface.h"

namespace tw {

/// What a surface hides, seen from the side (`up` 2, z over x) or from above (`up` 1, y over x): at each x, `step` [m]
/// apart, the union of what its triangles cover there.
PlotShadow silhouette(const Surface& surface, int up, double step);

}  // namespace tw
