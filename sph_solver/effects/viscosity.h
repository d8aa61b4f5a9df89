#pragma once
#include <memory>
#include <optional>

#include "sph_solver/effects/eddy_viscosity.h"
#include "sph_solver/effects/effect.h"

namespace tw {

/// Physical viscosity, equations/viscosity.h. The solids do not rub (slip) or hold the water (no slip), and so do the
/// walls of a tank (Mirrors::holding); symmetry planes and the sides of a stream never hold it.
struct Viscosity {
    double kinematic = 1e-6;  ///< nu [m2/s]
    bool no_slip = true;
    std::optional<EddyViscosity> turbulence;
};
std::unique_ptr<Effect> make_viscosity(const Viscosity& options);

}  // namespace tw
