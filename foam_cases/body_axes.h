#pragma once
#include "motion/rigid_body.h"

namespace tw {

/// The axes that OpenFOAM keeps a body's attitude in: those in which its inertia is diagonal.
struct BodyAxes {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< their columns in earth axes, at the start
    Vec3 moments = Vec3::Ones();                         ///< about them [kg m2]; where nothing turns they do not count
};

/// Of a body free to turn about one axis: the earth's axes and the moment about that one, which is all that counts.
BodyAxes body_axes(const RigidBodySetup& motion);

}  // namespace tw
