#include "motion/rigid_body.h"

#include <Eigen/LU>

namespace tw {
namespace {

/// Rotation by the vector `turn` [rad].
Eigen::Quaterniond rotation(const Vec3& turn) {
    const double angle = turn.norm();
    if (angle == 0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle));
}

Vec3 kept(const Vec3& v, const std::array<bool, 3>& free) {
    return {free[0] ? v.x() : 0, free[1] ? v.y() : 0, free[2] ? v.z() : 0};
}

}  // namespace

RigidBody::RigidBody(RigidBodySetup setup) : setup_(std::move(setup)) {
    state_.centre = setup_.mass.centre;
    if (setup_.law) {
        follow_law();
        return;
    }
    state_.velocity = kept(setup_.velocity, setup_.free.along);
    state_.angular_momentum = kept(setup_.mass.inertia * kept(setup_.spin, setup_.free.about), setup_.free.about);
}

Eigen::Matrix3d RigidBody::inertia_at(const Eigen::Quaterniond& attitude) const {
    const Eigen::Matrix3d turn = attitude.toRotationMatrix();
    return turn * setup_.mass.inertia * turn.transpose();
}

Eigen::Matrix3d RigidBody::inertia() const { return inertia_at(state_.attitude); }

Eigen::Matrix3d RigidBody::mobility_at(const Eigen::Quaterniond& attitude) const {
    const auto& free = setup_.free.about;
    if (!free[0] && !free[1] && !free[2]) return Eigen::Matrix3d::Zero();
    Eigen::Matrix3d inertia = inertia_at(attitude);
    for (int a = 0; a < 3; ++a) {
        if (free[static_cast<std::size_t>(a)]) continue;
        inertia.row(a).setZero();
        inertia.col(a).setZero();
        inertia(a, a) = 1;
    }
    Eigen::Matrix3d inverse = inertia.inverse();
    for (int a = 0; a < 3; ++a)
        if (!free[static_cast<std::size_t>(a)]) inverse(a, a) = 0;
    return inverse;
}

RigidBody::Mobility RigidBody::mobility() const {
    const auto& along = setup_.free.along;
    const Vec3 free(along[0], along[1], along[2]);
    return {Vec3(free / setup_.mass.mass).asDiagonal(), mobility_at(state_.attitude)};
}

Vec3 RigidBody::spin_at(const Eigen::Quaterniond& attitude) const {
    return kept(mobility_at(attitude) * state_.angular_momentum, setup_.free.about);
}

Vec3 RigidBody::spin() const {
    if (!setup_.law) return spin_at(state_.attitude);
    return setup_.law->turns ? Vec3(setup_.law->at(state_.time).rate * setup_.law->axis) : Vec3::Zero();
}

Vec3 RigidBody::prescribed_acceleration() const {
    if (!setup_.law || setup_.law->turns) return Vec3::Zero();
    return setup_.law->at(state_.time).acceleration * setup_.law->axis;
}

Vec3 RigidBody::prescribed_angular_acceleration() const {
    if (!setup_.law || !setup_.law->turns) return Vec3::Zero();
    return setup_.law->at(state_.time).acceleration * setup_.law->axis;
}

double RigidBody::kinetic_energy() const {
    const Eigen::Matrix3d turn = state_.attitude.toRotationMatrix();
    const Vec3 omega = spin();
    return 0.5 * setup_.mass.mass * state_.velocity.squaredNorm() +
           0.5 * omega.dot(turn * (setup_.mass.inertia * (turn.transpose() * omega)));
}

void RigidBody::kick(const Vec3& force, const Vec3& moment, double dt) {
    if (setup_.law || held()) return;
    state_.velocity += kept(dt / setup_.mass.mass * force, setup_.free.along);
    state_.angular_momentum += kept(dt * moment, setup_.free.about);
}

void RigidBody::drift(double dt) {
    const bool stays = held();
    state_.time += dt;
    if (setup_.law) return follow_law();
    if (stays) return;
    state_.centre += dt * state_.velocity;
    Vec3 omega = spin_at(state_.attitude);
    // a fixed point; each round gains a factor of |omega dt| and more
    for (int round = 0; round < 50; ++round) {
        const Vec3 next = spin_at(rotation(dt / 2 * omega) * state_.attitude);
        const bool settled = (next - omega).norm() <= 1e-15 * next.norm();
        omega = next;
        if (settled) break;
    }
    state_.attitude = (rotation(dt * omega) * state_.attitude).normalized();
}

void RigidBody::follow_law() {
    const MotionLaw::At now = setup_.law->at(state_.time);
    if (setup_.law->turns) {
        state_.attitude = rotation(now.path * setup_.law->axis);
        return;
    }
    state_.centre = setup_.mass.centre + now.path * setup_.law->axis;
    state_.velocity = now.rate * setup_.law->axis;
}

}  // namespace tw
