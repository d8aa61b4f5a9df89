#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/report/pictures.h"
#include "compare/report/svg_plot.h"

namespace tw {

/// Everything drawn of a comparison. `file`: name (without suffix) under figures/.
struct Figure {
    std::string file;
    LivePlot plot;
};
struct Figures {
    std::vector<Figure> forces, splash, wetting, cuts, probes, bodies;  ///< plots over time and along cuts
    std::vector<Figure> maps;                                           ///< mean elevation from above, one per source
    std::vector<Figure> resolution;                                     ///< where the runs are how fine; one or none
    std::string elevation_legend, pressure_legend;
    std::string splash_not_drawn;  ///< why height and amount of the spray are not: they are not resolved
    Pictures pictures;
};
Figures draw_figures(const Comparison& comparison);

}  // namespace tw
