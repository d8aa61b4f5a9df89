#include "compare/metrics/gauge_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "compare/metrics/wave_samples.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

constexpr std::string_view kinds[] = {"obstacle", "body"};

/// Where what is in the waves ends, along their way [m].
struct Range {
    double from = 0, to = 0;
};
std::vector<Range> ranges_in(const RunRecord& record) {
    const double way = number_of(record, "wave_direction", 1);
    std::vector<Range> ranges;
    for (const std::string_view kind : kinds) {
        const std::string low = fmt::format("{}_x_min_", kind);
        for (const auto& [name, x] : record.numbers) {
            if (!name.starts_with(low)) continue;
            const double other = number_of(record, fmt::format("{}_x_max_{}", kind, name.substr(low.size())), NAN);
            ranges.push_back({std::min(way * x, way * other), std::max(way * x, way * other)});
        }
    }
    return ranges;
}

}  // namespace

GaugeSides gauge_sides(const Comparison& comparison) {
    std::map<std::string, double> gauges;         // how far along the wave's way [m]
    double first = HUGE_VAL, last = -HUGE_VAL;    // of what counts, likewise
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
        for (const Range& range : ranges_in(r)) {
            const bool between =
                any([&](double at) { return at < range.from; }) && any([&](double at) { return at > range.to; });
            if (between) first = std::min(first, range.from), last = std::max(last, range.to);
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
