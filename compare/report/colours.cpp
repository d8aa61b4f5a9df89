#include "compare/report/colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/escape.h"
#include "compare/report/svg_plot.h"

namespace tw {

Rgb ColourScale::operator()(double value) const {
    const double at = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0) * static_cast<double>(stops_.size() - 1);
    const auto k = std::min(static_cast<std::size_t>(at), stops_.size() - 2);
    const double w = at - static_cast<double>(k);
    Rgb c{};
    for (std::size_t i = 0; i < 3; ++i) c[i] = (1 - w) * stops_[k][i] + w * stops_[k + 1][i];
    return c;
}

std::string ColourScale::legend(const std::string& label) const {
    constexpr int left = 20, width = 360, cells = 60;
    std::string out = fmt::format(
        "<svg class=\"scale\" viewBox=\"0 0 400 46\" role=\"img\" aria-label=\"{}\" "
        "xmlns=\"http://www.w3.org/2000/svg\">",
        escaped(label));
    for (int k = 0; k < cells; ++k) {
        const Rgb c = (*this)(low_ + (high_ - low_) * (k + 0.5) / cells);
        out += fmt::format(
            "<rect x=\"{:.1f}\" y=\"0\" width=\"{:.1f}\" height=\"12\" fill=\"rgb({:.0f},{:.0f},{:.0f})\"/>",
            left + 1.0 * width * k / cells, 1.0 * width / cells + 0.3, 255 * c[0], 255 * c[1], 255 * c[2]);
    }
    for (const double v : ticks(low_, high_, 6))
        out += fmt::format("<text class=\"tick mid\" x=\"{:.1f}\" y=\"25\">{:.4g}</text>",
                           left + width * (v - low_) / (high_ - low_), std::abs(v) < 1e-9 * (high_ - low_) ? 0 : v);
    return out + fmt::format("<text class=\"mid\" x=\"200\" y=\"41\">{}</text></svg>", escaped(label));
}

ColourScale elevation_scale(double half_range, double middle) {
    return ColourScale({{0.03, 0.13, 0.36},
                        {0.12, 0.38, 0.67},
                        {0.47, 0.72, 0.86},
                        {0.86, 0.93, 0.96},
                        {0.98, 0.80, 0.55},
                        {0.90, 0.45, 0.20},
                        {0.58, 0.10, 0.12}},
                       middle - half_range, middle + half_range);
}

ColourScale pressure_scale(double low, double high) {
    return ColourScale({{0.05, 0.03, 0.20},
                        {0.35, 0.07, 0.43},
                        {0.65, 0.17, 0.38},
                        {0.89, 0.35, 0.20},
                        {0.98, 0.65, 0.04},
                        {0.99, 0.99, 0.64}},
                       low, high);
}

}  // namespace tw
