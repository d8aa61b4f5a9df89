#pragma once
#include <string>
#include <vector>

namespace tw {

inline constexpr int most_levels = 6;  ///< of particle size

/// Numerics of the particle method, as a scene may set them in `[sph]`. The defaults stand here and nowhere else;
/// units, ranges and meanings stand in the table of keys (keys.h) and in the effects' parts.
struct SphOptions {
    double h_over_dp = 1.55;                 ///< smoothing length over spacing [-]
    double c0 = 0;                           ///< numerical sound speed [m/s]; 0: default_sound_speed, see defaults.cpp
    double delta = 0.1;                      ///< density diffusion [-]
    double alpha = 0.01;                     ///< artificial viscosity [-]
    std::string scheme = "kick_drift_kick";  ///< of the time step; the names of Scheme, sph_solver/domain/scheme.h
    double cfl = 0.7;                        ///< acoustic Courant number on h [-]; stable to 1.5 in still tanks
    std::string equation_of_state = "linear";  ///< linear, tait, mie_grueneisen
    double gamma = 7;                          ///< Tait exponent [-]
    double shifting = 1;                       ///< coefficient [-]; 0: off
    int levels = 1;    ///< sizes of particles, each half the one before; near_hull is the finest
    double zone = 16;  ///< width of the finest level's zone round the hull, in its spacings [-]
    /// Of the forcing zones of a stream, while the box has levels of its own or one size: fine, or coarse, twice as
    /// large.
    std::string zones = "fine";
    int wake = 0;  ///< largest particles in a hull's wake, over near_hull: a power of two; 0: as they come
    double touch_support = 0.9;  ///< how full the kernel's half towards a wall is when the wall compresses [-]
    std::vector<double> gate_point, gate_normal;  ///< a plane beyond which detached water leaves [m]; empty: none
    double gate_link = 2;                         ///< distance up to which particles hang together, in spacings [-]
    double smagorinsky = 0.12;                    ///< Cs of the effect "turbulence" [-]
    double acoustic_damping = 0.3;                ///< alpha2 of the effect "acoustic_damping" [-]
    double air_c0 = 343;                          ///< sound speed of the effect "air" [m/s]
};

}  // namespace tw
