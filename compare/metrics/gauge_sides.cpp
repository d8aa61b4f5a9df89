#include "compare/metrics/gauge_sides.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/metrics/wave_samples.h"
#include "record/record_numbers.h"

namespace tw {

GaugeSides gauge_sides(const Comparison& comparison) {
    constexpr std::string_view low = "obstacle_x_min_";
    std::map<std::string, double> gauges;         // how far along the wave's way [m]
    double first = HUGE_VAL, last = -HUGE_VAL;    // of the obstacles that count, likewise
    GaugeSides sides{gauges_of(comparison), {}};  // an imported measurement knows no places
    for (const RunRecord& r : comparison.sources)
        if (number_of(r, "wave_across", 0) != 0) return sides;  // an oblique wave passes obstacles at their sides
    for (const RunRecord& r : comparison.sources) {
        const double way = number_of(r, "wave_direction", 1);
        for (const std::string& gauge : sides.before)
            if (const double x = number_of(r, "height_x_" + gauge, NAN); std::isfinite(x)) gauges[gauge] = way * x;
    }
    const auto any = [&](auto holds) { return std::ranges::any_of(gauges, [&](auto& g) { return holds(g.second); }); };
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, x] : r.numbers) {
            if (!name.starts_with(low)) continue;
            const double way = number_of(r, "wave_direction", 1),
                         other = number_of(r, "obstacle_x_max_" + name.substr(low.size()), NAN),
                         from = std::min(way * x, way * other), to = std::max(way * x, way * other);
            if (!any([&](double at) { return at < from; }) || !any([&](double at) { return at > to; })) continue;
            first = std::min(first, from), last = std::max(last, to);
        }
    if (!(first < last)) return sides;
    sides.before.clear();
    for (const auto& [gauge, at] : gauges) {
        if (at < first) sides.before.insert(gauge);
        if (at > last) sides.behind.insert(gauge);
    }
    return sides;
}

}  // namespace tw
