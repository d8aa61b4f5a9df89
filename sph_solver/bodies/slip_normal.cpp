#include "sph_solver/bodies/slip_normal.h"

#include <cmath>

namespace tw {

Vec3 slip_normal(const SurfaceQuery& query, const SurfaceQuery::Nearest& nearest, const Vec3& u) {
    Vec3 normal = nearest.normal;
    double least = u.dot(normal);
    if (nearest.on_face() || least <= 0) return normal;
    for (const Vec3& face : query.faces_at(nearest))
        if (const double leaving = std::abs(u.dot(face)); leaving < least) least = leaving, normal = face;
    return normal;
}

}  // namespace tw
