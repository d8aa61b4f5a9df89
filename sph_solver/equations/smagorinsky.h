#pragma once
#include <algorithm>

#include "sph_solver/equations/renormalisation.h"

namespace tw {

/// Subgrid turbulence after Smagorinsky (1963), as sub-particle scale model (Dalrymple & Rogers 2006,
/// doi:10.1016/j.coastaleng.2005.10.004), without the isotropic part, which is a pressure:
///
///   nu_t = l^2 |S|,   |S| = sqrt(2 S_ab S_ab),   S_ab = (d_a u_b + d_b u_a) / 2,   l = min(Cs dp, kappa y)
///
/// y is the distance from a no-slip wall, kappa = 0.41. The velocity gradient is renormalised (exact for linear
/// fields). This is |S|^2.
template <class Real>
inline Real strain_rate_squared(const VectorGradient<Real>& grad) {
    const V3<Real>&u = grad.u, &v = grad.v, &w = grad.w;
    const Real xy = u.y + v.x, xz = u.z + w.x, yz = v.z + w.y;
    return 2.0f * (u.x * u.x + v.y * v.y + w.z * w.z) + xy * xy + xz * xz + yz * yz;
}

inline constexpr double von_karman = 0.41;  ///< kappa
inline double mixing_length_at_wall(double filter, double y) { return std::min(filter, von_karman * std::max(0.0, y)); }
inline double eddy_viscosity(double length, double S) { return length * length * S; }

}  // namespace tw
