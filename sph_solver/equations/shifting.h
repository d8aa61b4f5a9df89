#pragma once
#include <algorithm>
#include <cmath>

#include "sph_solver/equations/pair.h"

namespace tw {

/// Particle shifting: particles move from where they are crowded to where they are few (the sum is that of Sun et al.
/// 2017, doi:10.1016/j.cma.2016.10.028), as fast as the flow takes their order apart,
///
///   s_i       = sum_j (1 + 0.2 (W_ij / W(dp))^4) grad_i W_ij V_j     every neighbour: water, wall or air   [1/m]
///   v_i^2     = sum_j |u_i - u_j|^2 V_j W_ij                         every particle, of water or air       [m2/s2]
///   delta x_i = -shifting dt min(b v_i, c0 / 10) h s_i,   at most 0.05 dp
///
/// `shifting` is 1 unless a scene says otherwise. With the flow's largest speed in place of b v_i, as in the paper,
/// particles are packed denser than their density says even in a uniform stream, and a planing plate loses force, the
/// more the finer the particles. v_i is the same in every frame of reference, zero in a uniform stream and of order h,
/// so that shifting vanishes with the spacing. b is calibrated, on exact cases: a strained lattice gives way the better
/// the larger it is, and volume is kept the better the smaller (docs/decisions/024).
struct Shifting {
    static constexpr float b = 16;
    float crowding;  ///< 0.2 (W_over_G G / W(dp))^4, for the fourth power of Pair::relative_W

    Shifting(const Kernel& kernel, float inv_W_dp) {
        const float ratio = kernel.W_over_G * kernel.G * inv_W_dp, ratio2 = ratio * ratio;
        crowding = 0.2f * ratio2 * ratio2;
    }
    template <class Real, class Form>
    void add(const Pair<Real, Form>& ij, V3<Real>& sum) const {
        const Real W = ij.relative_W(), W2 = W * W;
        const Real share = crowding * (W2 * W2) + 1.0f;
        sum += share * ij.V_gradW();
    }
    /// |u_ij|^2 V_j W_ij / W_over_G to the sum of v_i^2.
    template <class Real, class Form>
    static void add_difference(const Pair<Real, Form>& ij, const V3<Real>& u_ij, Real& sum) {
        sum += ij.V_W() * dot(u_ij, u_ij);
    }
};

/// Within 2h of a free surface shifting goes along it only: towards it, it would pump water up for ever
/// (docs/decisions/024). The direction N_i = sum_j grad_i W_ij V_j over the neighbours j at the surface points towards
/// it:
///
///   s_i -= (s_i . N_i) N_i / |N_i|^2
inline void keep_along_surface(const V3<float>& N, float N2, V3<float>& s) {
    if (!(N2 > 0)) return;
    const float share = (s.x * N.x + s.y * N.y + s.z * N.z) / N2;
    s.x -= share * N.x, s.y -= share * N.y, s.z -= share * N.z;
}

/// delta x_i from min(b v_i, c0 / 10) s_i, for one step.
struct ShiftStep {
    double factor;   ///< [m s]
    double longest;  ///< [m]

    ShiftStep(double shifting, double dt, double h, double dp) : factor(-shifting * dt * h), longest(0.05 * dp) {}

    struct Displacement {
        V3<double> x;    ///< [m]
        double length2;  ///< [m2]
    };
    Displacement of(float vs_x, float vs_y, float vs_z) const {
        V3<double> x{factor * double(vs_x), factor * double(vs_y), factor * double(vs_z)};
        const double length2 = dot(x, x), longest2 = longest * longest;
        if (length2 > longest2) x = (longest / std::sqrt(length2)) * x;
        return {x, std::min(length2, longest2)};
    }
};

}  // namespace tw
