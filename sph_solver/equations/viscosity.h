#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Physical viscosity (Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776, with grad_i W_ij = F r_ji):
///
///   du_i/dt += 1/rho_i sum_j (mu_i + mu_j) F_ij (u_j - u_i) V_j
///
/// The factors 1/rho_i and 1/2h (F V = FV / 2h) are applied once after the sum.
struct ViscousForce {
    template <class Real, class Form>
    static void add(const Pair<Real, Form>& ij, const Real& mu_sum, const V3<Real>& u_ji, V3<Real>& force) {
        force += (ij.FV * mu_sum) * u_ji;
    }
};

/// No slip: a wall's dummy moves against the water round it, so that the velocity on the surface between is the wall's
/// u_w (Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005):
///
///   u_d = 2 u_w - sum_f u_f V_f W_df / sum_f V_f W_df
template <class A, class B>
inline auto no_slip_velocity(const V3<A>& u_w, const V3<B>& u_water) {
    return 2.0f * u_w - u_water;
}

}  // namespace tw
