#include "meshes/check/intersections.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "meshes/query/bvh.h"
#include "meshes/query/predicates.h"

namespace tw {
namespace {
using Corners = std::array<Vec3, 3>;

Corners corners(const Surface& s, int t) { return {s.corner(t, 0), s.corner(t, 1), s.corner(t, 2)}; }

/// Two triangles of one plane overlap when no edge of either separates them (separating axis theorem); touching along
/// an edge or at a corner is not an overlap.
bool overlap_in_plane(const Corners& a, const Corners& b) {
    const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
    const double slack = 1e-9 * std::max({(a[1] - a[0]).norm(), (a[2] - a[1]).norm(), (a[0] - a[2]).norm()});
    for (const auto& [from, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& origin = (*from)[k];
            Vec3 axis = normal.cross((*from)[(k + 1) % 3] - origin).stableNormalized();
            if (axis.dot((*from)[(k + 2) % 3] - origin) < 0) axis = -axis;
            double furthest = -1e300;
            for (const Vec3& p : *other) furthest = std::max(furthest, axis.dot(p - origin));
            if (furthest <= slack) return false;
        }
    return true;
}

/// The edge of `a` from corner k passes through `b`, its ends on either side of b's plane.
bool edge_pierces(const Corners& a, std::size_t k, const Corners& b) {
    const Vec3 &p = a[k], &q = a[(k + 1) % 3];
    if (!(orientation(b[0], b[1], b[2], p) * orientation(b[0], b[1], b[2], q) < 0)) return false;
    // One of the three may be undecided: the edge then runs through an edge of b. More than one says that the corners
    // lie in one plane up to rounding, where neighbours on a flat face would seem to meet.
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double side = orientation(p, q, b[i], b[(i + 1) % 3]);
        left += side > 0;
        right += side < 0;
    }
    return (left >= 2 && right == 0) || (right >= 2 && left == 0);
}

/// All corners within rounding of one plane.
bool in_one_plane(const Corners& a, const Corners& b) {
    const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
    double magnitude = 0;
    for (std::size_t k = 0; k < 3; ++k)
        magnitude = std::max({magnitude, a[k].cwiseAbs().maxCoeff(), b[k].cwiseAbs().maxCoeff()});
    return std::ranges::all_of(
        b, [&](const Vec3& p) { return std::abs(normal.dot(p - a[0])) <= 1e-12 * magnitude * normal.norm(); });
}

bool intersect(const Surface& s, int ta, int tb) {
    const auto& ia = s.triangles[static_cast<std::size_t>(ta)];
    const auto& ib = s.triangles[static_cast<std::size_t>(tb)];
    const auto shared_by = [](const std::array<int, 3>& t, int corner) {
        return std::ranges::find(t, corner) != t.end();
    };
    int shared = 0;
    for (const int corner : ia) shared += shared_by(ib, corner);
    if (shared == 3) return false;  // the same triangle twice: non-manifold edges
    const Corners a = corners(s, ta), b = corners(s, tb);
    if (in_one_plane(a, b)) return overlap_in_plane(a, b);
    if (shared == 2) return false;  // two planes meet in the shared edge only
    for (std::size_t k = 0; k < 3; ++k) {
        // With one corner shared, only the edge opposite to it can pierce the other triangle.
        const bool free_a = !shared_by(ib, ia[k]) && !shared_by(ib, ia[(k + 1) % 3]);
        const bool free_b = !shared_by(ia, ib[k]) && !shared_by(ia, ib[(k + 1) % 3]);
        if (free_a && edge_pierces(a, k, b)) return true;
        if (free_b && edge_pierces(b, k, a)) return true;
    }
    return false;
}
}  // namespace

std::vector<std::pair<int, int>> find_intersections(const Surface& surface, std::size_t limit) {
    const Bvh bvh(surface);
    const int count = static_cast<int>(surface.triangles.size());
    std::vector<std::pair<int, int>> found;
#pragma omp parallel for schedule(dynamic, 256)
    for (int t = 0; t < count; ++t) {
        const Corners c = corners(surface, t);
        const Vec3 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]), high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
        std::vector<std::pair<int, int>> of_triangle;
        bvh.visit(
            [&](const Box& box) {
                return (low.array() <= box.max.array()).all() && (high.array() >= box.min.array()).all();
            },
            [&](const Bvh::Corners& other) {
                const Vec3 other_low = other.a.cwiseMin(other.b).cwiseMin(other.c);
                const Vec3 other_high = other.a.cwiseMax(other.b).cwiseMax(other.c);
                if (other.triangle > t && (low.array() <= other_high.array()).all() &&
                    (high.array() >= other_low.array()).all() && intersect(surface, t, other.triangle))
                    of_triangle.emplace_back(t, other.triangle);
                return of_triangle.size() < limit;
            });
        if (!of_triangle.empty()) {
#pragma omp critical
            found.insert(found.end(), of_triangle.begin(), of_triangle.end());
        }
    }
    std::ranges::sort(found);
    if (found.size() > limit) found.resize(limit);
    return found;
}

}  // namespace tw
