#include "meshes/mass_properties.h"

namespace tw {
namespace {
/// Sutherland-Hodgman: the part of a triangle with z <= 0, a convex polygon of up to four corners.
int clip_below_water(const std::array<Vec3, 3>& triangle, std::array<Vec3, 4>& polygon) {
    int n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = triangle[k];
        const Vec3& b = triangle[(k + 1) % 3];
        if (a.z() <= 0) polygon[static_cast<std::size_t>(n++)] = a;
        if ((a.z() < 0 && b.z() > 0) || (a.z() > 0 && b.z() < 0)) {
            // From the lower to the upper end, so that both triangles of an edge cut it at the same point.
            const Vec3& low = a.z() < b.z() ? a : b;
            const Vec3& high = a.z() < b.z() ? b : a;
            Vec3 cut = low + low.z() / (low.z() - high.z()) * (high - low);
            cut.z() = 0;
            polygon[static_cast<std::size_t>(n++)] = cut;
        }
    }
    return n;
}
}  // namespace

Hydrostatics hydrostatics(const Surface& closed_surface) {
    Hydrostatics h;
    const Box box = closed_surface.bounds();
    if (closed_surface.points.empty() || box.min.z() >= 0) return h;
    // Tetrahedra with a point of the water plane: the waterplane itself, which closes the wet part, then adds nothing.
    const Vec3 origin(0.5 * (box.min.x() + box.max.x()), 0.5 * (box.min.y() + box.max.y()), 0);
    Vec3 first = Vec3::Zero();
    bool any = false;
    std::array<Vec3, 4> polygon;
    for (int t = 0; t < static_cast<int>(closed_surface.triangles.size()); ++t) {
        const int n = clip_below_water(
            {closed_surface.corner(t, 0), closed_surface.corner(t, 1), closed_surface.corner(t, 2)}, polygon);
        for (int k = 0; k < n; ++k) {
            const Vec3& p = polygon[static_cast<std::size_t>(k)];
            h.wet_bounds.min = any ? h.wet_bounds.min.cwiseMin(p).eval() : p;
            h.wet_bounds.max = any ? h.wet_bounds.max.cwiseMax(p).eval() : p;
            any = true;
        }
        for (int k = 2; k < n; ++k) {
            const Vec3 a = polygon[0] - origin, b = polygon[static_cast<std::size_t>(k - 1)] - origin,
                       c = polygon[static_cast<std::size_t>(k)] - origin;
            const double det = a.dot(b.cross(c));
            h.volume += det / 6;
            first += det / 24 * (a + b + c);
        }
    }
    h.centroid = h.volume != 0 ? Vec3(origin + first / h.volume) : origin;
    return h;
}

}  // namespace tw
