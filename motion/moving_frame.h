#pragma once
#include "motion/motion_law.h"
#include "motion/rigid_body.h"

namespace tw {

/// The force by mass that something feels in a frame that moves, at one moment: linear in place and velocity.
///
///   f(x, u) = at_pivot + gradient (x - pivot) - 2 spin x u
struct FrameForce {
    Vec3 at_pivot = Vec3::Zero();                        ///< [m/s2]
    Vec3 pivot = Vec3::Zero();                           ///< [m]
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  ///< [1/s2]
    Vec3 spin = Vec3::Zero();                            ///< [rad/s]

    Vec3 at(const Vec3& x, const Vec3& u) const { return at_pivot + gradient * (x - pivot) - 2 * spin.cross(u); }
};

/// A tank's own axes, which move as prescribed: along a direction of the earth, or about an axis through the pivot,
/// which stays in the earth. Both are the earth's axes where the path s is zero. Places and velocities in them obey
/// Newton's law with (Landau & Lifshitz, Mechanics, art. 39)
///
///   f = R^T g - a0 - alpha x r - omega x (omega x r) - 2 omega x u,    r = x - pivot
///
/// R = exp(s [axis]) turns the tank's axes to the earth's, a0 = s'' axis, omega = s' axis, alpha = s'' axis; the axis
/// is the same in both.
struct MovingFrame {
    MotionLaw law;
    Vec3 pivot = Vec3::Zero();  ///< of a rotation [m]

    /// At time `t`, with gravity in the earth's axes.
    FrameForce force(double t, const Vec3& gravity) const;
    /// What rests in the earth moves with this velocity in the tank at the start, uniform; of rotations zero, because
    /// they are let begin from rest only [m/s].
    Vec3 velocity_of_rest() const;
};

/// Moment about its centre of mass that a rigid body of this inertia about it and this spin in the frame feels [N m]:
///
///   M_i = e_ijk (A S)_kj,   A = gradient - 2 [spin x] [omega x],   S = int r r^T dm = tr(I) / 2 - I,
///
/// which is int r x f(X + r, U + omega x r) dm over the body.
Vec3 moment_on(const Eigen::Matrix3d& inertia, const Vec3& spin, const FrameForce& f);

/// Force and moment about the centre of mass [N], [N m].
struct FrameLoad {
    Vec3 force, moment;  ///< [N], [N m]
};

/// What a rigid body feels in such a frame, whose centre X, velocity U and spin omega are those in it: F = m f(X, U), and
/// the moment above. With it the body's momentum in the frame obeys Newton's law as it does in the earth.
FrameLoad load_on(const RigidBody& body, const FrameForce& f);

}  // namespace tw
