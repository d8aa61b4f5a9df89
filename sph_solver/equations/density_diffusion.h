#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Density diffusion: removes the pressure noise of weakly compressible SPH.
///
///   drho_i/dt += delta h c0 sum_j psi_ij . grad_i W_ij V_j
///   psi_ij     = 2 (rho_j - rho_i) r_ji / |r_ji|^2 - (<grad rho>_i + <grad rho>_j)
///
/// The gradient part (Antuono et al. 2010, doi:10.1016/j.cpc.2009.11.002) keeps still water at rest; without it
/// (Molteni & Colagrossi 2009, doi:10.1016/j.cpc.2008.12.004) the surface creeps. With r_ji in 2h the summand is
///
///   1/h FV (rho_j - rho_i - h (<grad rho>_i + <grad rho>_j) . r_ji)
///
/// so the sum wants the factor delta c0.
struct DensityDiffusion {
    float h;  ///< smoothing length [2h]
    template <class Real, class Form>
    void add(const Pair<Real, Form>& ij, const Real& drho_ji, const V3<Real>& grad_sum, Real& sum) const {
        sum += ij.FV * (drho_ji - h * dot(grad_sum, ij.r_ji));
    }
};

}  // namespace tw
