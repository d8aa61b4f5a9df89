#include "motion/moving_frame.h"

#include <Eigen/Geometry>

namespace tw {
namespace {

/// The matrix of a x.
Eigen::Matrix3d cross(const Vec3& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

}  // namespace

FrameForce MovingFrame::force(double t, const Vec3& gravity) const {
    const MotionLaw::At now = law.at(t);
    FrameForce f;
    f.pivot = pivot;
    if (!law.turns) {
        f.at_pivot = gravity - now.acceleration * law.axis;
        return f;
    }
    f.at_pivot = Eigen::AngleAxisd(-now.path, law.axis) * gravity;
    f.spin = now.rate * law.axis;
    f.gradient = -cross(now.acceleration * law.axis) - cross(f.spin) * cross(f.spin);
    return f;
}

Vec3 MovingFrame::velocity_of_rest() const { return law.turns ? Vec3::Zero() : Vec3(-law.at(0).rate * law.axis); }

Vec3 moment_on(const Eigen::Matrix3d& inertia, const Vec3& spin, const FrameForce& f) {
    const Eigen::Matrix3d S = 0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia,
                          AS = (f.gradient - 2 * cross(f.spin) * cross(spin)) * S;
    return {AS(2, 1) - AS(1, 2), AS(0, 2) - AS(2, 0), AS(1, 0) - AS(0, 1)};
}

FrameLoad load_on(const RigidBody& body, const FrameForce& f) {
    return {body.mass().mass * f.at(body.state().centre, body.state().velocity),
            moment_on(body.inertia(), body.spin(), f)};
}

}  // namespace tw
