#pragma once
#include <memory>
#include <optional>

#include "sph_solver/pair_loops/own_sums.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

class Effect;

/// Subgrid turbulence after Smagorinsky, equations/smagorinsky.h.
struct EddyViscosity {
    double cs = 0.12;  ///< Cs [-]
};

/// Physical viscosity, equations/viscosity.h. The solids do not rub (slip) or hold the water (no slip), and so do the
/// walls of a tank (Mirrors::holding); symmetry planes and the sides of a stream never hold it.
struct Viscosity {
    double kinematic = 1e-6;  ///< nu [m2/s]
    bool no_slip = true;
    std::optional<EddyViscosity> turbulence;
};
std::unique_ptr<Effect> make_effect(const Viscosity& options);

// What its pair loops read and write.

/// Velocity of the water round points (wall dummies): sum_f u_f V W / sum_f V W; drho takes sum_f V W.
struct WaterVelocityData {
    WaterView water{};
    Lists list{};  ///< of the points
    const PackedPlace* at = nullptr;
    OwnSums<PackedVelocityDensity> velocity{};
};
/// See equations/viscosity.h; adds to `rate`.
struct ViscousForceData {
    WaterView water{};
    WallView walls{};
    const float* mu = nullptr;                             ///< of particles and images [Pa s]
    const PackedVelocityDensity* wall_velocity = nullptr;  ///< of the dummies; null: slip
    PackedRate* rate = nullptr;
    WallLoad* wall_load = nullptr;
};
/// |S| of each particle [1/s], see equations/smagorinsky.h.
struct StrainRateData {
    WaterView water{};
    OwnSums<float> strain{};
};

}  // namespace tw
