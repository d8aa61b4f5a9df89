#pragma once
#include <memory>
#include <optional>

#include "meshes/query.h"

namespace tw::spray {

/// What water has to pass to become droplets: a plane, a closed surface to leave, or nothing.
class Gate {
public:
    /// Everything is beyond.
    Gate() = default;
    /// Beyond lies where `normal` points. Throws InputError: no direction, or not finite.
    static Gate plane(const Vec3& point, const Vec3& normal);
    /// Beyond lies outside.
    static Gate surface(const Surface& closed);

    bool is_open() const { return !plane_ && !surface_; }  ///< nothing has to be passed
    bool beyond(const Vec3& place) const;

private:
    struct Plane {
        Vec3 point, normal;
    };
    std::optional<Plane> plane_;
    std::shared_ptr<const SurfaceQuery> surface_;
};

}  // namespace tw::spray
