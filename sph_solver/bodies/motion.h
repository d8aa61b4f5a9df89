#pragma once
#include "base/vec3.h"

namespace tw {

/// The rigid motion of a body at one moment: what its dummies hand to the water. All zeros of a body that is fixed.
///
///   u(x) = U + omega x (x - X),   a(x) = dU/dt + domega/dt x (x - X) + omega x (omega x (x - X))
struct BodyMotion {
    Vec3 centre = Vec3::Zero();                ///< X [m]
    Vec3 velocity = Vec3::Zero();              ///< U [m/s]
    Vec3 rotation = Vec3::Zero();              ///< omega [rad/s]
    Vec3 acceleration = Vec3::Zero();          ///< dU/dt [m/s2]
    Vec3 angular_acceleration = Vec3::Zero();  ///< domega/dt [rad/s2]

    Vec3 velocity_at(const Vec3& x) const { return velocity + rotation.cross(x - centre); }
    Vec3 acceleration_at(const Vec3& x) const {
        return acceleration + angular_acceleration.cross(x - centre) + rotation.cross(rotation.cross(x - centre));
    }
};

}  // namespace tw
