#include "scene/solids/hull_bottom.h"

#include <algorithm>
#include <vector>

#include "base/numbers.h"

namespace tw {

namespace {

/// What is left of a convex polygon where `n . x <= at`.
std::vector<Vec3> cut(const std::vector<Vec3>& polygon, const Vec3& n, double at) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = n.dot(a) - at, to = n.dot(b) - at;
        if (from <= 0) kept.push_back(a);
        if (from * to < 0) kept.push_back(a + from / (from - to) * (b - a));
    }
    return kept;
}

constexpr double looks_down = -0.2;

/// Adds what of a triangle lies within `part`, if it looks down.
void add(Box& bounds, const Surface& hull, std::size_t triangle, const Box& part) {
    const auto& t = hull.triangles[triangle];
    std::vector<Vec3> polygon;
    for (const auto corner : t) polygon.push_back(hull.points[static_cast<std::size_t>(corner)]);
    const Vec3 normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]);
    if (!(normal.z() < looks_down * normal.norm())) return;
    const Vec3 low = polygon[0].cwiseMin(polygon[1]).cwiseMin(polygon[2]),
               high = polygon[0].cwiseMax(polygon[1]).cwiseMax(polygon[2]);
    if ((low.array() > part.max.array()).any() || (high.array() < part.min.array()).any()) return;
    for (int a = 0; a < 3; ++a) {
        polygon = cut(polygon, Vec3::Unit(a), part.max[a]);
        polygon = cut(polygon, -Vec3::Unit(a), -part.min[a]);
    }
    for (const Vec3& x : polygon) bounds = {bounds.min.cwiseMin(x), bounds.max.cwiseMax(x)};
}

std::optional<Box> unless_empty(const Box& bounds) {
    if (!(bounds.min.array() <= bounds.max.array()).all()) return {};
    return bounds;
}

Box nothing() { return {Vec3::Constant(infinite), Vec3::Constant(-infinite)}; }

}  // namespace

std::optional<Box> bottom_within(const Surface& hull, const Box& part) {
    Box bounds = nothing();
    for (std::size_t k = 0; k < hull.triangles.size(); ++k) add(bounds, hull, k, part);
    return unless_empty(bounds);
}

std::optional<Box> bottom_within(const Surface& hull, std::span<const std::size_t> triangles, const Box& part) {
    Box bounds = nothing();
    for (const std::size_t k : triangles) add(bounds, hull, k, part);
    return unless_empty(bounds);
}

std::vector<Breadth> breadths_within(const Surface& hull, std::span<const std::size_t> triangles, const Box& part,
                                     double apart) {
    std::vector<Breadth> all, joined;
    for (const std::size_t k : triangles) {
        Box bounds = nothing();
        add(bounds, hull, k, part);
        if (unless_empty(bounds)) all.push_back({bounds.min.y(), bounds.max.y()});
    }
    std::ranges::sort(all, {}, &Breadth::min);
    for (const Breadth& b : all)
        if (joined.empty() || b.min > joined.back().max + apart)
            joined.push_back(b);
        else
            joined.back().max = std::max(joined.back().max, b.max);
    return joined;
}

}  // namespace tw
