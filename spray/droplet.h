#pragma once
#include <cmath>
#include <numbers>

#include "base/vec3.h"

namespace tw::spray {

/// One spherical drop of water at the moment it is let go.
struct Droplet {
    Vec3 place = Vec3::Zero();     ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double diameter = 0;           ///< [m], above 0
    double time = 0;               ///< [s]
};

/// pi d^3 / 6 [m3].
inline double sphere_volume(double diameter) { return std::numbers::pi / 6 * diameter * diameter * diameter; }
/// Diameter of the sphere of that volume [m].
inline double sphere_diameter(double volume) { return std::cbrt(6 / std::numbers::pi * volume); }

/// Properties of the liquid; fresh water at 20 degrees unless said otherwise.
struct Liquid {
    double density = 1000;            ///< [kg/m3]
    double viscosity = 1.0e-3;        ///< dynamic [Pa s]
    double surface_tension = 0.0728;  ///< [N/m]
};

}  // namespace tw::spray
