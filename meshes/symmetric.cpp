#include "meshes/symmetric.h"

#include <cmath>

#include "meshes/query.h"

namespace tw {

Asymmetry asymmetry(const Surface& closed_surface) {
    const SurfaceQuery query(closed_surface);
    Asymmetry worst;
    for (const Vec3& p : closed_surface.points) {
        const double off = std::abs(query.nearest({p.x(), -p.y(), p.z()}).distance);
        if (off > worst.distance) worst = {off, p};
    }
    return worst;
}

Surface made_symmetric(const Surface& closed_surface, double reach) {
    Surface snapped = closed_surface;
    for (Vec3& p : snapped.points)
        if (std::abs(p.y()) <= reach) p.y() = 0;
    snapped = welded(snapped);
    Surface both;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        if (a.y() == 0 && b.y() == 0 && c.y() == 0) return;  // in the plane: it would be there twice
        for (const double side : {1.0, -1.0}) {
            const int first = static_cast<int>(both.points.size());
            for (const Vec3& p : {a, b, c}) both.points.emplace_back(p.x(), p.y() == 0 ? 0 : side * p.y(), p.z());
            if (side > 0)
                both.triangles.push_back({first, first + 1, first + 2});
            else
                both.triangles.push_back({first, first + 2, first + 1});
        }
    };
    for (int t = 0; t < static_cast<int>(snapped.triangles.size()); ++t) {
        // Sutherland-Hodgman: the part at y >= 0, up to four corners.
        std::vector<Vec3> kept;
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = snapped.corner(t, k), b = snapped.corner(t, (k + 1) % 3);
            if (a.y() >= 0) kept.push_back(a);
            if ((a.y() < 0) == (b.y() < 0) || a.y() == 0 || b.y() == 0) continue;
            // From the lower to the higher end, so that both triangles of an edge cut it at the same point.
            const Vec3 &low = a.y() < b.y() ? a : b, &high = a.y() < b.y() ? b : a;
            Vec3 cut = low + low.y() / (low.y() - high.y()) * (high - low);
            cut.y() = 0;
            kept.push_back(cut);
        }
        for (std::size_t k = 2; k < kept.size(); ++k) add(kept[0], kept[k - 1], kept[k]);
    }
    return welded(both);
}

}  // namespace tw
