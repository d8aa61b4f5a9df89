#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tw {

/// A curve; `source` chooses its colour (CSS class s0, s1, ...), `faint` a thin pale line behind the others.
struct PlotLine {
    std::string name;  ///< in the legend; empty: not there
    std::size_t source = 0;
    std::vector<double> x, y;  ///< [units of the axes], of equal length; NaN interrupts the line
    bool faint = false, dashed = false;
    bool points = false;  ///< a dot at every value
};
/// A settled mean with its interval over the window it was taken from.
struct PlotBand {
    std::size_t source = 0;
    double from = 0, to = 0, value = 0, half_width = 0;  ///< [units of the axes]
};
/// A horizontal reference with a label.
struct PlotLevel {
    std::string name;
    double value = 0;  ///< [unit of the axis y]
};
/// A picture laid under the axes in data coordinates.
struct PlotImage {
    std::string png_base64;
    double x_min = 0, x_max = 0, y_min = 0, y_max = 0;  ///< [units of the axes]
};

/// A box in data coordinates: its edges in the source's colour over a pale filling (none where dashed), its label where
/// there is room.
struct PlotBox {
    std::string label;
    std::size_t source = 0;
    bool dashed = false;
    double x_min = 0, x_max = 0, y_min = 0, y_max = 0;  ///< [units of the axes]
    std::vector<PlotBox> parts = {};  ///< boxes side by side along x, drawn as one outline in place of the box
};
/// A solid's shadow: at each x, `step` apart, it covers [low, high]; an x may come several times.
struct PlotShadow {
    double step = 0;                   ///< [unit of the axis x]
    std::vector<double> x, low, high;  ///< [units of the axes], of equal length
};

struct Plot {
    std::string title = {}, x_label = {}, y_label = {};
    std::vector<PlotLine> lines = {};
    std::vector<PlotBand> bands = {};
    std::vector<PlotLevel> levels = {};
    std::vector<PlotImage> images = {};
    std::vector<PlotBox> boxes = {};
    PlotShadow shadow = {};
    std::vector<PlotLine> outlines = {};  ///< drawn in the text's colour, e.g. the hull's plan view
    bool include_zero = false;
    bool equal_scales = false;  ///< metres alike on both axes: the height follows from the width
    bool clip_spikes =
        false;  ///< the y axis covers the middle 98 % of the values, so that a start-up spike does not flatten the rest
    bool log_x = false, log_y = false;  ///< values of 0 and below are not drawn on such an axis
    int width = 640, height = 300;      ///< [px]
};

/// Places of the points of a line that a drawing needs: of those that follow each other in one column (a number of its x)
/// the first, lowest, highest and last, and of a gap at least one that is not finite.
std::vector<std::size_t> thinned(const PlotLine& line, const std::function<double(double)>& column_of);

/// The plot as one <svg> element without scripts; colours come from the page's style sheet. "no data" when it has none.
std::string svg(const Plot& plot);
/// Several plots below each other in one <svg>.
std::string svg_column(const std::vector<Plot>& plots);

/// A plot as a file of its own, with the style sheet that the page would give it; empty for what is no plot.
std::string svg_file(const std::string& svg);

/// 1-2-5 ticks that cover [low, high].
std::vector<double> ticks(double low, double high, int about);
/// A tick's number, with as many decimals as ticks that lie `step` apart need.
std::string tick_text(double value, double step);
/// Decades within [low, high], and 2 and 5 of each where there are fewer than four; 0 < low.
std::vector<double> log_ticks(double low, double high);

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

/// A rectangle on a drawing, y down [px].
struct DrawnBox {
    double left = 0, top = 0, right = 0, bottom = 0;  ///< [px]
    bool overlaps(const DrawnBox& b) const {
        return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
    }
    bool holds(const DrawnBox& b) const {
        return left <= b.left && b.right <= right && top <= b.top && b.bottom <= bottom;
    }
};
/// One with a label of this width.
struct LabelBox : DrawnBox {
    double label_width = 0;  ///< [px]
};

/// Where the labels of boxes stand: in a corner of their box or beside it, within the frame, on no other label, and
/// across as few edges of boxes as can be. The smallest boxes, which have the least choice, come first. None: no room.
std::vector<std::optional<DrawnBox>> label_places(const std::vector<LabelBox>& boxes, const DrawnBox& frame);

}  // namespace tw
