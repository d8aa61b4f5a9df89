#include "compare/report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "compare/report/escape.h"
#include "compare/report/page.h"

namespace tw {
namespace {

using Json = nlohmann::ordered_json;

/// 32-bit floats, low byte first, as on every machine that this program and browsers run on.
std::string packed_floats(const std::vector<double>& values, const std::vector<std::size_t>& places) {
    std::string bytes;
    for (const std::size_t i : places) {
        const auto value = static_cast<float>(values[i]);
        char part[sizeof value];
        std::memcpy(part, &value, sizeof value);
        bytes.append(part, sizeof value);
    }
    return base64(bytes);
}

Json line_json(const PlotLine& line) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double x : line.x)
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    const double width = (high - low) / most_plot_columns;
    const auto kept = thinned(line, [&](double x) { return width > 0 ? std::floor((x - low) / width) : x; });
    return {{"name", line.name},
            {"source", line.source},
            {"faint", line.faint},
            {"dashed", line.dashed},
            {"points", line.points},
            {"x", packed_floats(line.x, kept)},
            {"y", packed_floats(line.y, kept)}};
}

}  // namespace

std::string plot_data(const Plot& plot) {
    Json data = {{"lines", Json::array()}, {"bands", Json::array()}, {"levels", Json::array()}};
    for (const PlotLine& line : plot.lines) data["lines"].push_back(line_json(line));
    for (const PlotBand& b : plot.bands)
        data["bands"].push_back(
            {{"source", b.source}, {"from", b.from}, {"to", b.to}, {"value", b.value}, {"half_width", b.half_width}});
    for (const PlotLevel& l : plot.levels) data["levels"].push_back({{"name", l.name}, {"value", l.value}});
    return script_data("class=\"plot-data\"", data);
}

LivePlot live_plot(const Plot& plot) {
    LivePlot live{svg(plot), {}};
    const bool curves = plot.images.empty() && plot.boxes.empty() && live.svg.starts_with("<svg");
    if (curves) live.data = plot_data(plot);
    return live;
}

std::string figure_html(const LivePlot& plot) {
    return "<figure>" + plot.svg + (*plots_script ? plot.data : "") + "</figure>";
}

}  // namespace tw
