#pragma once
#include "sph_solver/equations/kernel.h"
#include "sph_solver/equations/vector.h"

namespace tw {

// The right-hand side of delta-SPH as pair terms, each written once against `Real` (vector.h). Subscript i is the
// particle, j its neighbour, r_ji = x_j - x_i and u_ij = u_i - u_j; grad_i W_ij = F r_ji.

/// One pair as the terms see it, lengths in 2h.
template <class Real, class Form = WendlandC2>
struct Pair {
    V3<Real> r_ji;  ///< [2h]
    Real t;         ///< closeness 1 - |r_ji| / 2h, 0 beyond the support
    Real distance;  ///< |r_ji| [2h]; 1 beyond the support
    Real gradient;  ///< the kernel's, of t
    Real FV;        ///< grad_i W_ij V_j = FV r_ji [1/m]

    V3<Real> V_gradW() const { return FV * r_ji; }                 ///< grad_i W_ij V_j [1/m]
    Real V_W() const { return FV * Form::shape(t); }               ///< W_ij V_j / W_over_G [1/m], see SmoothingKernel
    Real relative_W() const { return gradient * Form::shape(t); }  ///< W_ij / (W_over_G G)
};

/// `GV_j`: the kernel's G times the neighbour's volume.
template <class Form = WendlandC2, class Real>
inline Pair<Real, Form> meet(const V3<Real>& r_ji, const Real& t, float GV_j) {
    Pair<Real, Form> ij;
    ij.r_ji = r_ji;
    ij.t = t;
    ij.distance = 1.0f - t;
    ij.gradient = Form::gradient(t);
    ij.FV = ij.gradient * GV_j;
    return ij;
}

}  // namespace tw
