#include "sph_solver/bodies/slip_normal.h"

#include <algorithm>
#include <cmath>

namespace tw {
namespace {

constexpr double sharp_edge =
    0.7;  ///< cosine of the angle between faces from which on (46 degrees) they do not pass for one
constexpr int edge_halvings = 6;

}  // namespace

Vec3 slip_normal(const SurfaceQuery& query, const SurfaceQuery::Nearest& nearest, const Vec3& u) {
    Vec3 normal = nearest.normal;
    double least = u.dot(normal);
    if (nearest.on_face() || least <= 0) return normal;
    for (const Vec3& face : query.faces_at(nearest))
        if (const double leaving = std::abs(u.dot(face)); leaving < least) least = leaving, normal = face;
    return normal;
}

std::optional<double> time_to_edge(const SurfaceQuery& query, const SurfaceQuery::Nearest& found, const Vec3& x,
                                   const Vec3& u, double reach) {
    const Vec3 along = u - u.dot(found.normal) * found.normal;
    const double speed = along.norm();
    if (!(speed > 0)) return {};
    const auto beyond = [&](double way) {
        const SurfaceQuery::Nearest there = query.nearest(x + way / speed * along, 2 * reach);
        if (there.triangle < 0 || there.on_face()) return false;
        return std::ranges::any_of(query.faces_at(there),
                                   [&](const Vec3& face) { return face.dot(found.normal) < sharp_edge; });
    };
    double before = 0, after = reach;
    if (!beyond(after)) return {};
    for (int k = 0; k < edge_halvings; ++k) {
        const double middle = 0.5 * (before + after);
        (beyond(middle) ? after : before) = middle;
    }
    return 0.5 * (before + after) / speed;
}

}  // namespace tw
