#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Mass conservation:
///
///   drho_i/dt = rho_i sum_j (u_i - u_j) . grad_i W_ij V_j
///
/// (Monaghan 1994, doi:10.1006/jcph.1994.1034). The factor rho_i is applied once after the sum.
struct Continuity {
    template <class Real, class Form>
    static void add(const Pair<Real, Form>& ij, const V3<Real>& u_ij, Real& divergence) {
        const V3<Real> V_gradW = ij.V_gradW();
        divergence += u_ij.x * V_gradW.x;
        divergence += u_ij.y * V_gradW.y;
        divergence += u_ij.z * V_gradW.z;
    }
};

/// Slip wall in the continuity sum: the wall's dummy moves with its own velocity u_j along the exterior normal n_i at
/// the fluid particle, and with the water along the wall, so that
///
///   u_i - u_wall = ((u_i - u_j) . n_i) n_i
///
/// A solid at rest has u_j = 0.
template <class Real>
inline V3<Real> slip_velocity(const Real& normal_speed, const V3<Real>& n_i) {
    return normal_speed * n_i;
}

}  // namespace tw
