#pragma once
#include <string>

#include "compare/report/svg_plot.h"

namespace tw {

/// A plot of the page: the drawing, and the block from which plots.js makes it one with values and zoom.
struct LivePlot {
    std::string svg, data;  ///< data: empty for maps, boxes and where there is nothing to draw
};
LivePlot live_plot(const Plot& plot);

/// The curves, bands and levels of a plot as a block of JSON within markup. Long series are thinned to
/// `most_plot_columns` columns, which keep their extremes.
std::string plot_data(const Plot& plot);
inline constexpr int most_plot_columns = 1000;

/// The plot as a <figure>; without the data in a build that has no script to read it.
std::string figure_html(const LivePlot& plot);

}  // namespace tw
