#pragma once
// Read by the solvers of both methods, on a GPU without a mathematical library, and by OpenFOAM's compilers in C++11.

namespace tw {

/// Numbers of a long-crested steady wave, and its velocities and surface from them. It runs under an angle b to x, of
/// which `direction` is the cosine and `across` the sine:
///
///   u = current + cos b sum_j U_j (E^j + D^j) cos(j theta),   E = exp(k z), D = exp(-k (z + 2 d))
///   v =           sin b sum_j U_j (E^j + D^j) cos(j theta)
///   w =                 sum_j U_j (E^j - D^j) sin(j theta),   theta = k (x cos b + y sin b - speed t) + phase
///   eta = sum_j eta_j cos(j theta)
///
/// With U_j = j B_j sqrt(g/k) / (1 + exp(-2 j k d)) that is the stream function of stream_function.h, in which no term
/// overflows. Still water is z = 0. SI units; plain numbers, so that it can be copied to a device.
struct WaveSum {
    static constexpr int most = 96;
    int terms = 0;
    double k = 0, depth = 0;  ///< [1/m], [m]
    double direction = 1;     ///< cos b: 1 towards +x, -1 towards -x
    double across = 0;        ///< sin b: 1 towards +y
    double speed = 0;         ///< of the crests, along the direction, seen from the scene's axes [m/s]
    double phase = 0;         ///< [rad]: a crest is at x = 0, t = 0 where it is 0
    double current = 0;       ///< mean velocity below the troughs, along x [m/s]
    double crest = 0;         ///< [m]; above it velocities are those at its height
    double U[most] = {};      ///< [m/s]
    double eta[most] = {};    ///< [m]
};

constexpr double turns_per_radian = 0.159154943091895335769;

/// exp(x) to rounding for |x| < 700, by its series after halving.
inline double wave_exp(double x) {
    const bool below = x < 0;
    if (below) x = -x;
    int doublings = 0;
    for (; x > 0.25; ++doublings) x /= 2;
    double e = 0;  // exp(x) - 1
    for (int n = 13; n >= 1; --n) e = (e + 1) * x / n;
    for (; doublings > 0; --doublings) e *= e + 2;
    return below ? 1 / (e + 1) : e + 1;
}

/// Cosine and sine of an angle in turns, |turns| < 1e9, by their series within an eighth of a turn.
inline void wave_circle(double turns, double& c, double& s) {
    turns -= static_cast<double>(static_cast<long long>(turns));  // -1 to 1
    const int quarters = static_cast<int>(4 * turns + (turns < 0 ? -0.5 : 0.5));
    const double a = 6.283185307179586476925 * (turns - 0.25 * quarters), a2 = a * a;
    double cosine = 1, sine = 1;
    for (int n = 18; n >= 2; n -= 2) cosine = 1 - cosine * a2 / (n * (n - 1));
    for (int n = 19; n >= 3; n -= 2) sine = 1 - sine * a2 / (n * (n - 1));
    sine *= a;
    switch (((quarters % 4) + 4) % 4) {
        case 0: c = cosine, s = sine; break;
        case 1: c = -sine, s = cosine; break;
        case 2: c = -cosine, s = -sine; break;
        default: c = sine, s = -cosine;
    }
}

inline void wave_angle(const WaveSum& wave, double x, double y, double t, double& c, double& s) {
    wave_circle((wave.k * (wave.direction * x + wave.across * y - wave.speed * t) + wave.phase) * turns_per_radian, c,
                s);
}

/// eta at (x, y, t) [m].
inline double wave_surface(const WaveSum& wave, double x, double y, double t) {
    double c1, s1, c = 1, s = 0, eta = 0;
    wave_angle(wave, x, y, t, c1, s1);
    for (int j = 0; j < wave.terms; ++j) {
        const double next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
        eta += wave.eta[j] * c;
    }
    return eta;
}

/// u, v and w at (x, y, z, t) [m/s].
inline void wave_velocity(const WaveSum& wave, double x, double y, double z, double t, double& u, double& v,
                          double& w) {
    if (z > wave.crest) z = wave.crest;
    if (z < -wave.depth) z = -wave.depth;
    const double E1 = wave_exp(wave.k * z), deep = wave.k * (z + 2 * wave.depth), D1 = deep < 40 ? wave_exp(-deep) : 0;
    double c1, s1, c = 1, s = 0, E = 1, D = 1, along = 0;
    wave_angle(wave, x, y, t, c1, s1);
    w = 0;
    for (int j = 0; j < wave.terms; ++j) {
        const double next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
        E *= E1;
        D *= D1;
        along += wave.U[j] * (E + D) * c;
        w += wave.U[j] * (E - D) * s;
    }
    u = wave.current + wave.direction * along;
    v = wave.across * along;
}

/// In the plane y = 0.
inline double wave_surface(const WaveSum& wave, double x, double t) { return wave_surface(wave, x, 0, t); }
inline void wave_velocity(const WaveSum& wave, double x, double z, double t, double& u, double& w) {
    double v;
    wave_velocity(wave, x, 0, z, t, u, v, w);
}

}  // namespace tw
