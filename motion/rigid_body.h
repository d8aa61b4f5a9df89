#pragma once
#include <array>
#include <optional>

#include "base/vec3.h"
#include "motion/motion_law.h"
#include "motion/rigid_mass.h"

namespace tw {

/// Which of a free body's motions are free: along and about the earth's axes x, y, z.
struct DegreesOfFreedom {
    std::array<bool, 3> along{true, true, true}, about{true, true, true};
    bool any() const { return along[0] || along[1] || along[2] || about[0] || about[1] || about[2]; }
};

/// The data from which a rigid body is made: a free one moves by its loads, one with a law is moved.
struct RigidBodySetup {
    RigidMass mass;                ///< at the start; of a prescribed body the centre alone counts
    DegreesOfFreedom free;         ///< of a body without a law
    std::optional<MotionLaw> law;  ///< prescribed motion
    Vec3 velocity = Vec3::Zero();  ///< of the centre at the start [m/s]; free bodies
    Vec3 spin = Vec3::Zero();      ///< angular velocity at the start [rad/s]; free bodies
    double release = 0;            ///< a free body is held where it stands until this time [s]
};

/// The motion of one rigid body, for both methods. Earth axes throughout.
///
/// A free body keeps the velocity of its centre of mass and its angular momentum L about it. Loads alone change them,
/// so that momentum is conserved to rounding whatever the steps:
///
///   kick:    U += dt F / m,   L += dt M            components that are locked stay zero
///   drift:   x += dt U,       q -> exp(dt omega) q,   omega = omega(q', L) in its middle, q' = exp(dt/2 omega) q
///
/// The spin that belongs to L is that of the motions that are free (P projects on them; locked ones have torques that
/// hold them and do no work, so P L is all that is needed):
///
///   omega = P (P I(q) P)^-1 P L,    I(q) = R(q) I_0 R(q)^T
///
/// The drift is the implicit midpoint rule on the group of rotations (momentum in earth axes as Simo & Wong 1991,
/// doi:10.1002/nme.1620310103): second order, symmetric in time, so energy does not drift, and L is untouched. Kick
/// and drift make a second-order step as kick-drift-kick.
class RigidBody {
public:
    explicit RigidBody(RigidBodySetup setup);

    bool prescribed() const { return setup_.law.has_value(); }
    const RigidMass& mass() const { return setup_.mass; }
    const DegreesOfFreedom& dofs() const { return setup_.free; }
    const std::optional<MotionLaw>& law() const { return setup_.law; }
    /// Not released yet: loads do not act on it and it stays.
    bool held() const { return state_.time < setup_.release; }

    /// All that changes.
    struct State {
        double time = 0;                                               ///< [s]
        Vec3 centre = Vec3::Zero();                                    ///< of mass [m]
        Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< turns the axes at the start to those now
        Vec3 velocity = Vec3::Zero();                                  ///< of the centre [m/s]
        Vec3 angular_momentum = Vec3::Zero();  ///< about the centre; zero of a prescribed body [kg m2/s]
    };
    const State& state() const { return state_; }
    void set_state(const State& state) { state_ = state; }

    /// Where a point of the body is now that was at `x` at the start [m].
    Vec3 now(const Vec3& x) const { return state_.centre + state_.attitude * (x - setup_.mass.centre); }
    Vec3 spin() const;                             ///< angular velocity [rad/s]
    Eigen::Matrix3d inertia() const;               ///< about the centre, as the body is turned now [kg m2]
    Vec3 prescribed_acceleration() const;          ///< of the centre; zero of a free body [m/s2]
    Vec3 prescribed_angular_acceleration() const;  ///< [rad/s2]
    double kinetic_energy() const;                 ///< [J]
    /// What impulse and moment of it change: U by linear F, omega by angular M; locked motions nothing. Of a free body.
    struct Mobility {
        Eigen::Matrix3d linear, angular;  ///< [1/kg], [1/(kg m2)]
    };
    Mobility mobility() const;

    /// For the time `dt` [s] force and moment about the centre act on a free body; a prescribed one ignores them.
    void kick(const Vec3& force, const Vec3& moment, double dt);
    /// Moves on for the time `dt` [s].
    void drift(double dt);

private:
    Eigen::Matrix3d inertia_at(const Eigen::Quaterniond& attitude) const;
    Eigen::Matrix3d mobility_at(const Eigen::Quaterniond& attitude) const;
    Vec3 spin_at(const Eigen::Quaterniond& attitude) const;
    void follow_law();

    RigidBodySetup setup_;
    State state_;
};

}  // namespace tw
