#include "meshes/shedding_edges.h"

#include <cmath>
#include <optional>

#include "meshes/check/edges.h"

namespace tw {
namespace {

constexpr double cos_sharp = 0.8660254037844387;  // 30 degrees between the normals: the angle of the snapped edges

/// Water flows along such a face until it ends: it looks down by more than 12 degrees, and not astern.
bool is_bottom(const Vec3& normal) { return normal.z() < -0.2 && normal.x() < 0.3; }
/// Water arrives at such a face.
bool looks_ahead(const Vec3& normal) { return normal.x() < -0.5; }

/// The part of from-to inside the box.
std::optional<SheddingEdge> clipped(SheddingEdge e, const Box& box) {
    double first = 0, last = 1;
    const Vec3 along = e.to - e.from;
    for (int a = 0; a < 3; ++a) {
        if (along[a] == 0) {
            if (e.from[a] < box.min[a] || e.from[a] > box.max[a]) return {};
            continue;
        }
        const double low = (box.min[a] - e.from[a]) / along[a], high = (box.max[a] - e.from[a]) / along[a];
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
    }
    if (!(last > first)) return {};
    e.to = e.from + last * along;
    e.from += first * along;
    return e;
}

}  // namespace

std::vector<SheddingEdge> shedding_edges(const Surface& hull, const Box& within) {
    std::vector<SheddingEdge> out;
    const Edges edges = find_edges(hull);
    for (const Edge& edge : edges.edges) {
        if (edge.count() != 2 || edges.flipped(edge)) continue;
        const EdgeUse &one = edges.uses[edge.begin], &other = edges.uses[edge.begin + 1];
        const Vec3 a = hull.area_vector2(one.triangle).normalized(), b = hull.area_vector2(other.triangle).normalized();
        if (!a.allFinite() || !b.allFinite() || a.dot(b) > cos_sharp) continue;
        if (is_bottom(a) == is_bottom(b) || looks_ahead(a) || looks_ahead(b)) continue;
        const Vec3& low = hull.points[static_cast<std::size_t>(one.low)];
        const Vec3& high = hull.points[static_cast<std::size_t>(one.high)];
        // With outward normals a and b, a x b points the way in which a's triangle runs along the edge if it is convex.
        const Vec3 direction = (high - low) * (one.forward ? 1 : -1);
        if (a.cross(b).dot(direction) <= 0) continue;
        const Vec3 inward = -(a + b);
        if (!(inward.norm() > 1e-6)) continue;  // a plate without thickness
        if (const auto e = clipped({low, high, inward.normalized()}, within)) out.push_back(*e);
    }
    return out;
}

double length_of(const std::vector<SheddingEdge>& edges) {
    double sum = 0;
    for (const SheddingEdge& e : edges) sum += (e.to - e.from).norm();
    return sum;
}

Surface ribbon(const std::vector<SheddingEdge>& edges, double width) {
    Surface s;
    for (const SheddingEdge& e : edges) {
        const int n = static_cast<int>(s.points.size());
        s.points.insert(s.points.end(), {e.from, e.to, e.to + width * e.inward, e.from + width * e.inward});
        s.triangles.push_back({n, n + 1, n + 2});
        s.triangles.push_back({n, n + 2, n + 3});
    }
    return s;
}

}  // namespace tw
