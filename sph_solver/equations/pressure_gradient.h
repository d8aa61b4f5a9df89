#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Pressure gradient:
///
///   du_i/dt = -1/rho_i sum_j (p_i + p_j) grad_i W_ij V_j
///
/// (Colagrossi & Landrini 2003, doi:10.1016/S0021-9991(03)00324-3); conserves momentum pair by pair. The factor 1/rho_i
/// is applied once after the sum.
struct PressureGradient {
    template <class Real, class Form>
    static void add(const Pair<Real, Form>& ij, const Real& p_sum, V3<Real>& force) {
        force -= (ij.FV * p_sum) * ij.r_ji;
    }
};

}  // namespace tw
