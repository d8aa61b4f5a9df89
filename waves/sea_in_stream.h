#pragma once
#include "wave_components.h"

// Read by the particles' loops, on a GPU without a mathematical library too.

namespace tw {

/// Linear head waves on one another that a steady stream along +x carries, for single places at any times; plain numbers
/// that fit into the arguments of a kernel. Of component n, with omega_n = k_n C_n in the water and sigma_n = omega_n +
/// k_n stream as it is met:
///
///   u_n = a_n omega_n cosh(k_n (z + d)) / sinh(k_n d) cos(theta_n),   theta_n = k_n x - sigma_n t + phase_n
///   w_n = a_n omega_n sinh(k_n (z + d)) / sinh(k_n d) sin(theta_n),   p_n/rho = C_n u_n
///
/// Above still water u is that at z = 0, and w grows upwards as -z du/dx, so that no volume is made there.
struct SeaInStream {
    static constexpr int lanes = WaveComponents::lanes, most = WaveComponents::most;
    int count = 0;            ///< a multiple of `lanes`
    double depth = 0;         ///< [m]
    double stream = 0;        ///< [m/s]
    double carried = 0;       ///< sum_n of the water carried along, mean over the depth, over C_n [-]
    double k[most] = {};      ///< [1/m]
    double met[most] = {};    ///< sigma_n [rad/s]
    double speed[most] = {};  ///< a_n omega_n / (1 - exp(-2 k_n d)) [m/s]
    double phase[most] = {};  ///< in turns
    double floor[most] = {};  ///< exp(-2 k_n d)
};

/// Of components with direction 1.
inline SeaInStream sea_in_stream(const WaveComponents& waves) {
    SeaInStream sea;
    sea.depth = waves.depth;
    sea.stream = waves.stream;
    sea.count = (waves.count + SeaInStream::lanes - 1) / SeaInStream::lanes * SeaInStream::lanes;
    for (int n = 0; n < sea.count; ++n) sea.k[n] = sea.met[n] = 1;  // of none: no speed, and nothing is divided by 0
    for (int n = 0; n < waves.count; ++n) {
        const double k = waves.k[n], a = waves.height[n], deep = 2 * k * waves.depth,
                     floor = deep < 40 ? wave_exp(-deep) : 0;
        sea.k[n] = k;
        sea.met[n] = waves.omega[n] + k * waves.stream;
        sea.speed[n] = a * waves.omega[n] / (1 - floor);
        sea.phase[n] = waves.phase[n] * turns_per_radian;
        sea.floor[n] = floor;
        sea.carried += a * a * k * (1 + floor) / (1 - floor) / (2 * waves.depth);
    }
    return sea;
}

/// sum_n u_n C_n^power and sum_n w_n C_n^power at (x, z, t): for power 0 velocities, for 1 the first is p/rho, for -1 they
/// are the slopes that `go_behind` follows (wave_path.h).
template <int power>
inline void sea_sums(const SeaInStream& sea, double x, double z, double t, double& along, double& up) {
    constexpr int lanes = SeaInStream::lanes;
    const double above = z > 0 ? z : 0;
    if (z > 0) z = 0;
    if (z < -sea.depth) z = -sea.depth;
    double u[lanes] = {}, w[lanes] = {}, slope[lanes] = {};
    for (int from = 0; from < sea.count; from += lanes)
        for (int l = 0; l < lanes; ++l) {
            const int n = from + l;
            double C, S, E;
            wave_lane((sea.k[n] * x - sea.met[n] * t) * turns_per_radian + sea.phase[n], sea.k[n] * z, C, S, E);
            const double D = sea.floor[n] / E, c = sea.met[n] / sea.k[n] - sea.stream,
                         speed = sea.speed[n] * (power == 0  ? 1
                                                 : power > 0 ? c
                                                             : 1 / c);
            u[l] += speed * (E + D) * C;
            w[l] += speed * (E - D) * S;
            slope[l] -= sea.k[n] * speed * (E + D) * S;
        }
    double widens = 0;
    along = up = 0;
    for (int l = 0; l < lanes; ++l) along += u[l], up += w[l], widens += slope[l];
    up -= above * widens;
}

/// sum_n psi_n / C_n [m] and its derivative along z [-], with u_n = d psi_n/dz and w_n = -d psi_n/dx.
inline void sea_lift(const SeaInStream& sea, double x, double z, double t, double& lifted, double& per_z) {
    const double above = z > 0 ? z : 0;
    if (z > 0) z = 0;
    if (z < -sea.depth) z = -sea.depth;
    lifted = per_z = 0;
    for (int n = 0; n < sea.count; ++n) {
        double C, S, E;
        wave_lane((sea.k[n] * x - sea.met[n] * t) * turns_per_radian + sea.phase[n], sea.k[n] * z, C, S, E);
        const double D = sea.floor[n] / E, c = sea.met[n] / sea.k[n] - sea.stream, part = sea.speed[n] / c * C;
        lifted += part * (E - D) / sea.k[n];
        per_z += part * (E + D);
    }
    lifted += above * per_z;
}

}  // namespace tw
