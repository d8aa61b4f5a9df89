#pragma once
#include "wave_sum.h"

// Read by the solvers of both methods, on a GPU without a mathematical library, and by OpenFOAM's compilers in C++11.

namespace tw {

/// Linear waves on one another, all under one angle b to x, of which `direction` is the cosine and `across` the sine:
///
///   eta = sum_n a_n cos(theta_n),   theta_n = k_n ((x - stream t) cos b + y sin b) - omega_n t + phase_n
///   u   = current + cos b sum_n a_n omega_n cosh(k_n (z + d)) / sinh(k_n d) cos(theta_n)
///   v   =           sin b sum_n a_n omega_n cosh(k_n (z + d)) / sinh(k_n d) cos(theta_n)
///   w   =                 sum_n a_n omega_n sinh(k_n (z + d)) / sinh(k_n d) sin(theta_n)
///
/// Still water is z = 0; above it velocities are those at z = 0, since the linear ones of the shortest components have
/// no meaning in the crests of the longest. SI units; plain numbers, so that it can be copied to a device.
struct WaveComponents {
    static constexpr int lanes = 8, most = 96;
    int count = 0;
    double depth = 0;          ///< [m]
    double direction = 1;      ///< cos b: 1 towards +x, -1 towards -x
    double across = 0;         ///< sin b: 1 towards +y
    double current = 0;        ///< mean velocity below the troughs, along x [m/s]
    double stream = 0;         ///< that carries them, along x [m/s]
    double k[most] = {};       ///< [1/m]
    double omega[most] = {};   ///< in the water [rad/s]
    double height[most] = {};  ///< amplitudes a_n [m]
    double phase[most] = {};   ///< [rad]
};

/// The same at one moment, for many places: Re and Im of a_n omega_n exp(i theta_n(x = y = 0)) / (1 - exp(-2 k_n d)).
struct WaveMoment {
    int count = 0;  ///< a multiple of `lanes`
    double depth = 0, direction = 1, across = 0, current = 0;
    double k[WaveComponents::most] = {};
    double c[WaveComponents::most] = {}, s[WaveComponents::most] = {};  ///< [m/s]
    double floor[WaveComponents::most] = {};                            ///< exp(-2 k d)
};

inline double wave_surface(const WaveComponents& waves, double x, double y, double t) {
    double eta = 0;
    for (int n = 0; n < waves.count; ++n) {
        double c, s;
        wave_circle((waves.k[n] * waves.direction * (x - waves.stream * t) + waves.k[n] * waves.across * y -
                     waves.omega[n] * t + waves.phase[n]) *
                        turns_per_radian,
                    c, s);
        eta += waves.height[n] * c;
    }
    return eta;
}
/// In the plane y = 0.
inline double wave_surface(const WaveComponents& waves, double x, double t) { return wave_surface(waves, x, 0, t); }

inline WaveMoment wave_moment(const WaveComponents& waves, double t) {
    WaveMoment now;
    now.depth = waves.depth;
    now.direction = waves.direction;
    now.across = waves.across;
    now.current = waves.current;
    now.count = (waves.count + WaveComponents::lanes - 1) / WaveComponents::lanes * WaveComponents::lanes;
    for (int n = 0; n < waves.count; ++n) {
        const double deep = 2 * waves.k[n] * waves.depth;
        double c, s;
        const double met = waves.omega[n] + waves.direction * waves.k[n] * waves.stream;
        wave_circle((waves.phase[n] - met * t) * turns_per_radian, c, s);
        now.k[n] = waves.k[n];
        now.floor[n] = deep < 40 ? wave_exp(-deep) : 0;
        const double speed = waves.height[n] * waves.omega[n] / (1 - now.floor[n]);
        now.c[n] = speed * c;
        now.s[n] = speed * s;
    }
    return now;
}

/// 1 - cos(a) over a^2/2 and sin(a)/a by their series in a2 = a^2, |a| below pi/4; exp(y), |y| below 5/8. Written out, so
/// that compilers lay lanes side by side.
// clang-format off
inline double wave_less(double a) {
    return 1 - a * (1.0/12) * (1 - a * (1.0/30) * (1 - a * (1.0/56) * (1 - a * (1.0/90) * (1 - a * (1.0/132) *
           (1 - a * (1.0/182))))));
}
inline double wave_sine(double a) {
    return 1 - a * (1.0/6) * (1 - a * (1.0/20) * (1 - a * (1.0/42) * (1 - a * (1.0/72) * (1 - a * (1.0/110) *
           (1 - a * (1.0/156))))));
}
inline double wave_small_exp(double y) {
    return 1 + y * (1 + y * (1.0/2) * (1 + y * (1.0/3) * (1 + y * (1.0/4) * (1 + y * (1.0/5) * (1 + y * (1.0/6) *
           (1 + y * (1.0/7) * (1 + y * (1.0/8) * (1 + y * (1.0/9) * (1 + y * (1.0/10) * (1 + y * (1.0/11) *
           (1 + y * (1.0/12))))))))))));
}
// clang-format on

/// Cosine and sine of an angle in turns, |turns| < 1e9, and E = exp(kz) for kz <= 0; below exp(-40) nothing moves.
/// Without a branch.
inline void wave_lane(double turns, double kz, double& C, double& S, double& E) {
    // of a quarter of the angle from its nearest whole turn, doubled twice
    turns -= (turns + 6755399441055744.0) - 6755399441055744.0;  // 1.5 2^52: rounds to a whole number
    const double a = 1.57079632679489661923 * turns, a2 = a * a;
    const double S1 = a * wave_sine(a2), C1 = 1 - 0.5 * a2 * wave_less(a2);
    const double S2 = 2 * S1 * C1, C2 = 1 - 2 * S1 * S1;
    S = 2 * S2 * C2, C = 1 - 2 * S2 * S2;
    // of a 64th of the exponent, squared six times
    const double q = kz * (1.0 / 64) + 0.625,  // its larger of q and -0.625, without a branch:
        E1 = wave_small_exp(0.5 * (q + __builtin_fabs(q)) - 0.625), E2 = E1 * E1, E4 = E2 * E2, E8 = E4 * E4,
                 E16 = E8 * E8, E32 = E16 * E16;
    E = E32 * E32;
}

/// u, v and w at (x, y, z) [m/s], to 1e-11 of the largest. Components go side by side in lanes, without a branch.
inline void wave_velocity(const WaveMoment& now, double x, double y, double z, double& u, double& v, double& w) {
    constexpr int lanes = WaveComponents::lanes;
    if (z > 0) z = 0;
    if (z < -now.depth) z = -now.depth;
    const double turns_per_k = (now.direction * x + now.across * y) * turns_per_radian;
    double along[lanes] = {}, up[lanes] = {};
    for (int from = 0; from < now.count; from += lanes)
        for (int l = 0; l < lanes; ++l) {
            const int n = from + l;
            double C, S, E;
            wave_lane(now.k[n] * turns_per_k, now.k[n] * z, C, S, E);
            const double D = now.floor[n] / E;  // exp(-k (z + 2 d))
            along[l] += (E + D) * (now.c[n] * C - now.s[n] * S);
            up[l] += (E - D) * (now.c[n] * S + now.s[n] * C);
        }
    double whole = 0;
    w = 0;
    for (int l = 0; l < lanes; ++l) whole += along[l], w += up[l];
    u = now.current + now.direction * whole;
    v = now.across * whole;
}
/// In the plane y = 0.
inline void wave_velocity(const WaveMoment& now, double x, double z, double& u, double& w) {
    double v;
    wave_velocity(now, x, 0, z, u, v, w);
}

}  // namespace tw
