#pragma once
#include <Eigen/Core>

#include "meshes/surface.h"

namespace tw {

/// Solid of uniform density inside a closed surface, by the divergence theorem (Mirtich 1996).
struct MassProperties {
    double volume = 0;                                  ///< signed [m3]; negative: inverted normals
    double area = 0;                                    ///< [m2]
    Vec3 centroid = Vec3::Zero();                       ///< [m]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centroid, per unit density [m5]
};
MassProperties mass_properties(const Surface& surface);

/// The part below z = 0: volume [m3], its centroid (the centre of buoyancy) and bounds, by exact clipping. All zero
/// when nothing lies below z = 0.
struct Hydrostatics {
    double volume = 0;             ///< [m3]
    Vec3 centroid = Vec3::Zero();  ///< [m]
    Box wet_bounds;                ///< bounds of the wetted part of the surface
};
Hydrostatics hydrostatics(const Surface& closed_surface);

}  // namespace tw
