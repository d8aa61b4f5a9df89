#include "stability/heat_map.h"

#include <fmt/format.h>

#include "compare/report/escape.h"

namespace tw {

namespace {

constexpr int left = 64, top = 34, cell_width = 84, cell_height = 34, bottom = 44, right = 10;
constexpr const char* text_style = "font-family:system-ui,'DejaVu Sans',sans-serif;fill:#1b1f24;";

std::string text(double x, double y, const std::string& words, const std::string& style) {
    return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" style=\"{}{}\">{}</text>", x, y, text_style, style,
                       escaped(words));
}

}  // namespace

const char* colour_of(Stability stability) {
    switch (stability) {
        case Stability::stable: return "#a6d8b0";
        case Stability::warned: return "#f5d77c";
        case Stability::failed: return "#eb9c8c";
    }
    return "#ffffff";
}

HeatMap heat_map(const StabilityMap& map) {
    const int columns = static_cast<int>(map.x.values.size()), rows = static_cast<int>(map.y.values.size());
    HeatMap out;
    out.width = left + columns * cell_width + right;
    out.height = top + rows * cell_height + bottom;
    std::string& s = out.svg;
    s = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "role=\"img\" aria-label=\"{2}\">"
        "<rect width=\"{0}\" height=\"{1}\" style=\"fill:#ffffff\"/>",
        out.width, out.height, escaped(map.title));
    s += text(left, 20, map.title, "font-size:13.5px;font-weight:600");
    for (int iy = 0; iy < rows; ++iy) {
        const int y = top + (rows - 1 - iy) * cell_height;  // values grow upwards
        s += text(left - 8, y + 0.5 * cell_height + 4, fmt::format("{:g}", map.y.values[static_cast<std::size_t>(iy)]),
                  "font-size:12px;text-anchor:end");
        for (int ix = 0; ix < columns; ++ix) {
            const MapCell& cell = map.at(static_cast<std::size_t>(ix), static_cast<std::size_t>(iy));
            const StabilityJudgement& j = cell.judgement;
            const int x = left + ix * cell_width;
            s += fmt::format(
                "<g><title>{}: {}{}</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                "style=\"fill:{};stroke:#ffffff;stroke-width:2\"/>",
                escaped(describe(cell.c)), to_string(j.stability), j.reason.empty() ? "" : ": " + escaped(j.reason), x,
                y, cell_width, cell_height, colour_of(j.stability));
            s += text(x + 0.5 * cell_width, y + 14, to_string(j.stability), "font-size:11px;text-anchor:middle") +
                 text(x + 0.5 * cell_width, y + 28, j.label, "font-size:11px;text-anchor:middle") + "</g>";
        }
    }
    for (int ix = 0; ix < columns; ++ix)
        s += text(left + (ix + 0.5) * cell_width, top + rows * cell_height + 16,
                  fmt::format("{:g}", map.x.values[static_cast<std::size_t>(ix)]), "font-size:12px;text-anchor:middle");
    s += text(left + 0.5 * columns * cell_width, top + rows * cell_height + 35, map.x.name,
              "font-size:12px;text-anchor:middle");
    const double middle = top + 0.5 * rows * cell_height;
    s += fmt::format("<g transform=\"translate(16 {:.0f}) rotate(-90)\">", middle) +
         text(0, 0, map.y.name, "font-size:12px;text-anchor:middle") + "</g></svg>";
    return out;
}

}  // namespace tw
