#include "compare/report/hull_pressure.h"

#include <algorithm>
#include <cmath>

#include "compare/report/base64.h"
#include "meshes/query/bvh.h"
#include "meshes/query/predicates.h"

namespace tw {
namespace {

/// The triangle next to a place among those whose normals are within 90 degrees of `area_vector`; -1: there is none.
int nearest_facing(const Bvh& tree, const Vec3& place, const Vec3& area_vector) {
    int nearest = -1;
    double least = HUGE_VAL;
    tree.visit_nearest(place, least, [&](const Bvh::Corners& t) {
        const double distance2 = (nearest_on_triangle(place, t.a, t.b, t.c).point - place).squaredNorm();
        if (distance2 < least && (t.b - t.a).cross(t.c - t.a).dot(area_vector) > 0)
            least = distance2, nearest = t.triangle;
        return least;
    });
    return nearest;
}

}  // namespace

std::optional<double> wet_pressure(const RunRecord& record, std::size_t triangle) {
    if (triangle >= record.hull_pressure.size() || !std::isfinite(record.hull_pressure[triangle])) return {};
    if (triangle < record.hull_wet.size() && !(record.hull_wet[triangle] > 0.05f)) return {};
    return record.hull_pressure[triangle];
}

std::optional<PressureRange> pressure_range(const Comparison& comparison) {
    std::vector<double> values;
    for (const RunRecord& r : comparison.sources)
        for (std::size_t t = 0; t < r.hull_pressure.size(); ++t)
            if (const auto p = wet_pressure(r, t)) values.push_back(*p);
    if (values.empty()) return {};
    std::ranges::sort(values);
    const std::size_t cut = values.size() / 100;
    PressureRange range{std::min(0.0, values[cut]), values[values.size() - 1 - cut]};
    if (!(range.high > range.low)) range.high = range.low + 1;
    return range;
}

std::string packed_pressures(const RunRecord& record, const Surface& recorded, const Surface& drawn,
                             const PressureRange& range) {
    const Bvh tree(recorded);
    std::string bytes;
    bytes.reserve(drawn.triangles.size());
    for (int t = 0; t < static_cast<int>(drawn.triangles.size()); ++t) {
        const Vec3 middle = (drawn.corner(t, 0) + drawn.corner(t, 1) + drawn.corner(t, 2)) / 3;
        const int nearest = nearest_facing(tree, middle, drawn.area_vector2(t));
        const auto pressure =
            nearest < 0 ? std::optional<double>() : wet_pressure(record, static_cast<std::size_t>(nearest));
        const double share = pressure ? (*pressure - range.low) / (range.high - range.low) : 0;
        bytes += static_cast<char>(pressure ? std::lround(254 * std::clamp(share, 0.0, 1.0)) : 255);
    }
    return base64(bytes);
}

}  // namespace tw
