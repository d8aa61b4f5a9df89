#pragma once
#include <cstdint>

namespace tw {

// Packed arrays: what the pair loops read and write, plain so that the loops can be compiled once per instruction set
// (and for a GPU) without dragging other code along. One neighbour costs three 16-byte loads.

/// Position in fixed-point units (FixedPoint), modulo 2^32; volume m/rho [m3].
struct alignas(16) PackedPlace {
    std::int32_t x, y, z;
    float volume;
};
/// a - b for coordinates modulo 2^32: exact for places up to 8000 dp apart, however long the domain is.
[[gnu::always_inline]] constexpr std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// Velocity [m/s] and density deviation rho - rho0 [kg/m3].
struct alignas(16) PackedVelocityDensity {
    float u, v, w, drho;
};
/// Renormalised density gradient [kg/m4] and pressure [Pa].
struct alignas(16) PackedGradientPressure {
    float gx, gy, gz, p;
};

/// Per-particle result of the first pair loop.
struct alignas(16) PackedShiftSupport {
    float x, y, z;  ///< min(b v_i, c0 / 10) s_i of shifting.h [1/s]; after the second pair loop along the free surface
    float support;  ///< sum_j V_j W_ij, walls and the particle itself counted [-]
};
/// What the other phase adds to the first pair loop's sums, see equations/level_pair.h: of shifting [1/m], support [-],
/// -div u [1/s], v^2 of shifting [m2/s2].
struct OtherSums {
    float x, y, z, support, compression, difference2;
};
/// Per-particle rates [m/s2], [kg/m3/s].
struct alignas(16) PackedRate {
    float ax, ay, az, drho;
};
/// What the walls of one body do to one cluster, per unit of particle mass: sum of the accelerations, and of arm x
/// acceleration about the cluster's centre (pair forces are central, so the arm may end at the fluid particle).
struct WallLoad {
    float ax = 0, ay = 0, az = 0, mx = 0, my = 0, mz = 0;  ///< [m/s2], [m2/s2]
    std::int32_t body = 0;
};
/// Velocity of the solid at a dummy [m/s].
struct alignas(16) WallVelocity {
    float u, v, w;
};
/// Acceleration of the solid at a dummy [m/s2].
struct alignas(16) WallAcceleration {
    float x, y, z;
};
/// Exterior unit normal of the nearest wall at a fluid particle (zero when none is near) and the distance from it [m]
/// (far when none is near), carried along between two searches by the particle's motion along the normal.
struct alignas(16) PackedWallNormal {
    float x, y, z, distance;
};
inline constexpr PackedWallNormal no_wall{0, 0, 0, 1e30f};

/// The velocity past the nearest wall of a particle before or beyond an edge [m/s], zero elsewhere, and when it passes
/// that edge, from the moment on at which the nearest wall was found [s].
struct alignas(16) PackedLeaving {
    float u, v, w, passes;
};

/// How much of the pressure the pair forces carry from a particle: m = sum_j r_ji (x) grad_i W_ij V_j. In the continuum
/// it is the unit tensor; among particles the momentum flux is the sum of V p m over those in a volume, not p of it.
struct CarriedShare {
    float xx, xy, xz, yy, yz, zz;  ///< [-]
};

}  // namespace tw
