#include "scene/refined_places.h"

#include <algorithm>
#include <cmath>

namespace tw {

Box wake_of(const Scene& scene, double width, std::optional<double> length) {
    const Box hull = scene.hull->surface.bounds();
    const double half = 0.75 * hull.size().y(), top = std::max(0.0, hull.max.z());
    return {Vec3(hull.min.x() + hull.size().x() / 2, -half - width, -scene.hull->draft - width),
            Vec3(length ? hull.max.x() + *length : scene.domain.box.max.x(), half + width, top + width)};
}

int sizes_below_near_hull(const Scene& scene) {
    int below = 0;
    for (const RefinedPlace& place : scene.refined) below = std::max(below, -place.halvings_short);
    return below;
}

double finest_spacing(const Scene& scene) {
    return std::ldexp(scene.resolution.near_hull, -sizes_below_near_hull(scene));
}

}  // namespace tw
