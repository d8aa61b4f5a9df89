#pragma once
#include "sph_solver/pair_loops/views.h"

namespace tw {

/// Smoothing length of the interpolation, narrower than that of the pairs (1.55): what goes through is damped less
/// (0.13 (k h)^2 of a wave of number k) and half as many particles are visited; narrower still, the order of the
/// particles shows (docs/decisions/031).
inline constexpr double interpolation_h_over_dp = 1.2;

/// Fields of one level's particles at places of another level's, see equations/first_order.h. The density is
/// carried along the hydrostatic line to the place first.
struct InterpolateData {
    WaterView water{};                       ///< the particles and images that count, and the kernel
    Lists list{};                            ///< of the clusters of places among them
    const PackedPlace* at = nullptr;         ///< the places, in clusters as particles are
    const float* known_support = nullptr;    ///< Shepard sum at each of the particles [-]; may be null
    PackedVelocityDensity* value = nullptr;  ///< at the places
    float* support = nullptr;                ///< sum_j V_j W_j [-]
    float* mean_support = nullptr;           ///< mean of `known_support` [-]
    const float* rate = nullptr;   ///< another field of the particles, as the density rate [kg/m3/s]; may be null
    float* compression = nullptr;  ///< that field at the places [kg/m3/s]
    float gx = 0, gy = 0, gz = 0;            ///< slope of the hydrostatic density, rho0 g / c0^2 [kg/m4]
};

}  // namespace tw
