#pragma once
#include <cstddef>
#include <cstdint>

#include "base/exact_sum.h"

namespace tw {

/// Force and moment of the water on a body, as solved (a half model's half).
struct Load {
    Vec3 force = Vec3::Zero();     ///< [N] (per metre of width in two dimensions)
    Vec3 friction = Vec3::Zero();  ///< the part of it that is viscous [N]
    Vec3 moment = Vec3::Zero();    ///< about the run's moment reference [N m]

    Load& operator+=(const Load& other) {
        force += other.force, friction += other.friction, moment += other.moment;
        return *this;
    }
};
inline Load operator*(double factor, const Load& load) {
    return {factor * load.force, factor * load.friction, factor * load.moment};
}

/// Sum of forces or impulses on a body and of their moments, the same in any order.
struct PushSum {
    ExactVectorSum push, turn;

    /// `arm`: from the point of reference to where it acts.
    void add(const Vec3& part, const Vec3& arm) {
        push += part;
        turn += arm.cross(part);
    }
    PushSum& operator+=(const PushSum& other) {
        push += other.push, turn += other.turn;
        return *this;
    }
};

/// A force of water that presses on a place of a body's surface.
struct WallPush {
    std::size_t body;
    std::int32_t triangle;
    Vec3 place, force;  ///< [m], [N]
};
/// An impulse that a particle held at a wall gave to a place of it.
struct WallImpulse {
    std::size_t body;
    std::int32_t triangle;
    Vec3 place, impulse;  ///< [m], [N s]
};
/// An impulse to a body: impulse [N s], and its moment about the run's moment reference [N m s].
struct Impulse {
    Vec3 impulse = Vec3::Zero(), turn = Vec3::Zero();
};

}  // namespace tw
