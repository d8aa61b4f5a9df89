#pragma once

namespace tw {

/// Subgrid turbulence after Smagorinsky (1963), as sub-particle scale model (Dalrymple & Rogers 2006,
/// doi:10.1016/j.coastaleng.2005.10.004), without the isotropic part, which is a pressure:
///
///   nu_t = l^2 |S|,   |S| = sqrt(2 S_ab S_ab),   l = min(Cs dp, kappa y)
///
/// y is the distance from a no-slip wall, kappa = 0.41. The velocity gradient is renormalised (exact for linear
/// fields).
struct EddyViscosity {
    double cs = 0.12;
};

}  // namespace tw
