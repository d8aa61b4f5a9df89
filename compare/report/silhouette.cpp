#include "compare/report/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tw {

namespace {

using Interval = std::pair<double, double>;

/// Of a triangle on the upright line at x; its corners reach from one side of that line to the other.
Interval covered(const std::array<Vec3, 3>& corners, int up, double x) {
    Interval c{HUGE_VAL, -HUGE_VAL};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = corners[k], &b = corners[(k + 1) % 3];
        if ((a.x() - x) * (b.x() - x) > 0) continue;
        const double along = a.x() == b.x() ? 0 : (x - a.x()) / (b.x() - a.x());
        const double v = a[up] + along * (b[up] - a[up]);
        c = {std::min(c.first, v), std::max(c.second, v)};
    }
    return c;
}

}  // namespace

PlotShadow silhouette(const Surface& surface, int up, double step, const std::array<double, 2>& shown) {
    std::map<long, std::vector<Interval>> lines;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const std::array<Vec3, 3> corners{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
        auto [low, high] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
        low = std::max(low, shown[0]), high = std::min(high, shown[1]);
        if (!(low <= high)) continue;
        for (long k = std::lround(std::ceil(low / step)); double(k) * step <= high; ++k)
            lines[k].push_back(covered(corners, up, double(k) * step));
    }
    PlotShadow shadow;
    shadow.step = step;
    for (auto& [k, intervals] : lines) {
        std::ranges::sort(intervals);
        const std::size_t first = shadow.x.size();
        for (const auto& [low, high] : intervals) {
            if (shadow.x.size() > first && low <= shadow.high.back()) {
                shadow.high.back() = std::max(shadow.high.back(), high);
                continue;
            }
            shadow.x.push_back(double(k) * step);
            shadow.low.push_back(low);
            shadow.high.push_back(high);
        }
    }
    return shadow;
}

}  // namespace tw
