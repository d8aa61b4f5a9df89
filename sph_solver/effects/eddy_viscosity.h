#pragma once

namespace tw {

/// Subgrid turbulence after Smagorinsky, equations/smagorinsky.h.
struct EddyViscosity {
    double cs = 0.12;  ///< Cs
};

}  // namespace tw
