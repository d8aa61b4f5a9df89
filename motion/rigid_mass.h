#pragma once
#include <string>

#include "base/vec3.h"
#include "meshes/surface.h"

namespace tw {

/// Mass, centre of mass and inertia of a rigid body. Of a section (two dimensions) per metre of span.
struct RigidMass {
    double mass = 0;                                    ///< [kg]
    Vec3 centre = Vec3::Zero();                         ///< of mass [m]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, in the axes of the surface [kg m2]
};

/// Of a solid of uniform density [kg/m3] inside a closed surface, by the divergence theorem (meshes/mass_properties.h).
RigidMass solid_mass(const Surface& surface, double density);

/// The same body about another centre of mass, by the parallel-axis theorem: as if its density were skewed so that the
/// inertia about the old centre stays.
RigidMass with_centre(const RigidMass& of, const Vec3& centre);

/// Why no body can have this mass or inertia; empty if one can. The mass is positive, and so is each principal moment;
/// none is larger than the sum of the other two (that of a flat plate across itself is the sum).
std::string impossible(const RigidMass& mass);

}  // namespace tw
