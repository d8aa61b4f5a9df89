#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Artificial viscosity:
///
///   du_i/dt += alpha h c0 rho0 / rho_i sum_j pi_ij grad_i W_ij V_j
///   pi_ij    = (u_j - u_i) . r_ji / (|r_ji|^2 + 0.01 h^2)
///
/// (Monaghan & Gingold 1983, doi:10.1016/0021-9991(83)90036-0, in the form of Antuono et al. 2010,
/// doi:10.1016/j.cpc.2009.11.002, acting on approaching and receding pairs alike). Along the same direction as the
/// pressure gradient, so it enters as a pressure beside p_i + p_j. With r_ji in 2h, 0.01 h^2 is 0.0025 and pi_ij has
/// the factor 1/2h.
///
/// `Math` makes quotients: exactly, or as well as a variant of the passes wants them.
template <class Math = ExactMath>
struct ArtificialViscosity {
    float viscosity;  ///< alpha c0 rho0 / 2 [kg/m2/s]
    template <class Real, class Form>
    Real pressure(const Pair<Real, Form>& ij, const V3<Real>& u_ij) const {
        return Math::quotient(viscosity * dot(u_ij, ij.r_ji), ij.distance * ij.distance + 0.0025f);
    }
};

}  // namespace tw
