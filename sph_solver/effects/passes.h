#pragma once
#include "sph_solver/backend/pass_data.h"

namespace tw {

// The pair sweeps of the effects: what they read and write. They are compiled once per instruction set.

/// Velocity of the water round points (wall dummies): sum_f u_f V W / sum_f V W; drho takes sum_f V W.
struct VelocityData {
    Lists list;  ///< of the points
    const PlaceRecord* at = nullptr;
    const PassData* water = nullptr;
    VelocityDensityRecord* velocity = nullptr;
};
/// See equations/viscosity.h; adds to `water->rate`.
struct ViscousData {
    const PassData* water = nullptr;
    const float* mu = nullptr;                             ///< of particles and images [Pa s]
    const VelocityDensityRecord* wall_velocity = nullptr;  ///< of the dummies; null: slip
    WallLoad* wall_load = nullptr;
};
/// |S| of each particle [1/s], see equations/smagorinsky.h.
struct StrainData {
    const PassData* water = nullptr;
    float* strain = nullptr;
};
/// See equations/surface_tension.h.
struct ColourData {
    const PassData* water = nullptr;
    VelocityDensityRecord* normal =
        nullptr;                 ///< `colour_gradient` writes grad C [1/m]; `surface_curvature` reads the unit
                                 ///< normal, of images too, with drho = 1 where it counts and 0 elsewhere
    float* curvature = nullptr;  ///< -div n [1/m]
};

/// See equations/level_pair.h: `meet_other_phase` fills sums, `press_other_phase` adds to `own->rate`.
struct LevelPairData {
    Lists list;  ///< neighbours of `own` in `other`
    const PassData *own = nullptr, *other = nullptr;
    OtherSums* sums = nullptr;
};

}  // namespace tw
