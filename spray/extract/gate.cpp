#include "spray/extract/gate.h"

#include "base/errors.h"

namespace tw::spray {

Gate Gate::plane(const Vec3& point, const Vec3& normal) {
    if (!point.allFinite() || !normal.allFinite() || !(normal.norm() > 0))
        throw InputError("gate: its point and normal have to be finite, and the normal longer than 0");
    Gate gate;
    gate.plane_ = Plane{point, normal.normalized()};
    return gate;
}

Gate Gate::surface(const Surface& closed) {
    Gate gate;
    gate.surface_ = std::make_shared<const SurfaceQuery>(closed);
    return gate;
}

bool Gate::beyond(const Vec3& place) const {
    if (plane_) return (place - plane_->point).dot(plane_->normal) > 0;
    return !surface_ || !surface_->inside(place);
}

}  // namespace tw::spray
