#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "compare/report/svg_plot.h"
#include "record/run_record.h"

namespace tw {

/// Where runs of one scene are how fine: side view and, in three dimensions, plan view of the domain with the hull's
/// silhouette, still water, every box in which particles or cells are smaller, with its size, and a rectangle outside
/// of which a stream's forcing zones lie. One <svg> element; empty where all runs have one size everywhere and no
/// zones. `names`: of the runs, for the legend.
std::string resolution_picture(std::span<const RunRecord> runs, const std::vector<std::string>& names);

/// The same also where there is one size everywhere; hatched, the water at the start in a tank, `water`.
std::string domain_picture(std::span<const RunRecord> runs, const std::vector<std::string>& names,
                           std::span<const Box> water = {});

/// What a surface hides, seen from the side (`up` 2, z over x) or from above (`up` 1, y over x): at each x, `step` [m]
/// apart from `shown[0]` to `shown[1]`, the union of what its triangles cover there.
PlotShadow silhouette(const Surface& surface, int up, double step, const std::array<double, 2>& shown);

}  // namespace tw
