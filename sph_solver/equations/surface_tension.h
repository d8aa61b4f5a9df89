#pragma once
#include "sph_solver/equations/renormalisation.h"

namespace tw {

/// Surface tension as a force per volume in the surface's kernel width (Brackbill, Kothe & Zemach 1992,
/// doi:10.1016/0021-9991(92)90240-Y; for particles Morris 2000,
/// doi:10.1002/1097-0363(20000615)33:3<333::AID-FLD11>3.0.CO;2-7):
///
///   du_i/dt += 2 sigma / rho_i kappa_i grad C_i
///   grad C   = sum_j grad_i W_ij V_j                      (walls count as water; points into the water)
///   kappa    = -div n,   n = grad C / |grad C|            (where |grad C| > 0.15/h)
///
/// The divergence is renormalised over the neighbours that have a normal. Only the water's half of the surface layer is
/// there, hence the 2.
struct ColourGradient {
    template <class Real, class Form>
    static void add(const Pair<Real, Form>& ij, V3<Real>& gradC) {
        gradC += ij.V_gradW();
    }
};
inline constexpr double smallest_colour_gradient = 0.15;  ///< |grad C| h from which a particle has a normal

/// sum_j (n_j - n_i) (x) grad_i W_ij V_j, renormalised, is the gradient of n; its trace the divergence.
template <class Real>
inline Real curvature(const VectorGradient<Real>& grad_n) {
    return -grad_n.divergence();
}

/// The acceleration's component along n, with 1 / rho_i = V_i / m.
struct SurfaceForce {
    float per_mass;  ///< 2 sigma / m [1/s2]
    SurfaceForce(double sigma, double m) : per_mass(static_cast<float>(2 * sigma / m)) {}
    float along_normal(float V, float kappa, float gradC) const { return per_mass * V * kappa * gradC; }
};

}  // namespace tw
