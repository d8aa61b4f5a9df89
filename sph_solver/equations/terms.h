#pragma once
// The right-hand side of delta-SPH as pair terms. Each is written once against `Real`: a SIMD vector over the particles
// of a group on the CPU, a float on a GPU. Subscript i is the particle, j its neighbour, r_ji = x_j - x_i, grad_i W_ij
// = F r_ji.

namespace tw {

template <class Real>
struct V3 {
    Real x, y, z;
};
template <class A, class B>
inline auto dot(const V3<A>& a, const V3<B>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
inline auto operator-(const V3<A>& a, const V3<B>& b) {
    return V3<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A, class B>
inline auto operator+(const V3<A>& a, const V3<B>& b) {
    return V3<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}

/// One pair as the terms see it, lengths in 2h. What belongs to j alone is a scalar, the same for all lanes.
template <class Real>
struct Pair {
    V3<Real> r_ji;  ///< [2h]
    Real distance;  ///< |r_ji| [2h]; 1 beyond the support, where FV is 0
    Real FV;        ///< grad_i W_ij V_j = FV r_ji [1/m]
};

/// Mass conservation:  drho_i/dt = rho_i sum_j (u_i - u_j) . grad_i W_ij V_j
/// (Monaghan 1994, doi:10.1006/jcph.1994.1034). The factor rho_i is applied once after the sum.
struct Continuity {
    /// `gradient` is grad_i W_ij V_j.
    template <class Real>
    static void add(const V3<Real>& gradient, const V3<Real>& u_ij, Real& divergence) {
        divergence += u_ij.x * gradient.x;
        divergence += u_ij.y * gradient.y;
        divergence += u_ij.z * gradient.z;
    }
};

/// Density diffusion: removes the pressure noise of weakly compressible SPH.
///
///   drho_i/dt += delta h c0 sum_j psi_ij . grad_i W_ij V_j
///   psi_ij     = 2 (rho_j - rho_i) r_ji / |r_ji|^2 - (<grad rho>_i + <grad rho>_j)
///
/// The gradient part (Antuono et al. 2010, doi:10.1016/j.cpc.2009.11.002) keeps still water at rest; without it
/// (Molteni & Colagrossi 2009, doi:10.1016/j.cpc.2008.12.004) the surface creeps. With r_ji in 2h the summand is
/// (1/h) FV (rho_j - rho_i - h (<grad rho>_i + <grad rho>_j) . r_ji): the sum wants the factor delta c0.
struct DensityDiffusion {
    float h;
    template <class Real>
    void add(const Pair<Real>& ij, const Real& drho_ji, const V3<Real>& grad_sum, Real& sum) const {
        sum += ij.FV * (drho_ji - h * dot(grad_sum, ij.r_ji));
    }
};

/// Pressure gradient:  du_i/dt = -1/rho_i sum_j (p_i + p_j) grad_i W_ij V_j
/// (Colagrossi & Landrini 2003, doi:10.1016/S0021-9991(03)00324-3); conserves momentum pair by pair.
struct PressureGradient {
    template <class Real>
    static void add(const Pair<Real>& ij, const Real& p_sum, V3<Real>& force) {
        const Real f = ij.FV * p_sum;
        force.x -= f * ij.r_ji.x;
        force.y -= f * ij.r_ji.y;
        force.z -= f * ij.r_ji.z;
    }
};

/// Artificial viscosity:  du_i/dt += alpha h c0 rho0 / rho_i sum_j pi_ij grad_i W_ij V_j,
///   pi_ij = (u_j - u_i) . r_ji / (|r_ji|^2 + 0.01 h^2)
/// (Monaghan & Gingold 1983, in the form of Antuono et al. 2010, acting on approaching and receding pairs alike). Along
/// the same direction as the pressure gradient, so it enters as a pressure beside p_i + p_j. With r_ji in 2h, 0.01 h^2
/// is 0.0025 and pi_ij has the factor 1/2h.
struct ArtificialViscosity {
    float viscosity;  ///< alpha c0 rho0 / 2
    template <class Real>
    Real pressure(const Pair<Real>& ij, const V3<Real>& u_ij) const {
        return viscosity * dot(u_ij, ij.r_ji) / (ij.distance * ij.distance + 0.0025f);
    }
};

}  // namespace tw
