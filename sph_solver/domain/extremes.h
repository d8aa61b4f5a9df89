#pragma once
#include <cstdint>

#include "base/vec3.h"

namespace tw {

/// Extremes of one step of one level, for the time step and the limits below.
struct Extremes {
    double speed = 0, acceleration = 0;                              ///< [m/s], [m/s2]
    double density_deviation_low = 0, density_deviation_high = 0;    ///< rho - rho0 [kg/m3]
    std::int64_t fastest = -1;                                       ///< id of the fastest particle
    Vec3 fastest_place = Vec3::Zero(), densest_place = Vec3::Zero(), thinnest_place = Vec3::Zero();
};

/// Beyond these a run is stopped: density deviation over rho0, and speed over c0 [-].
inline constexpr double largest_density_deviation = 0.3, largest_mach = 1.0;
/// Beyond these the run continues and its validity checks say that the sound speed is too low: speed over c0 (the
/// density's error grows with its square) and compression [-].
inline constexpr double trusted_mach = 0.15, trusted_compression = 0.05;
/// The same of a gas, which may be compressed: speed over its sound speed [-].
inline constexpr double trusted_air_mach = 0.5;

}  // namespace tw
