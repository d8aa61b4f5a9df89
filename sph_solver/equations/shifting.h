#pragma once
#include <algorithm>
#include <cmath>

#include "sph_solver/equations/pair.h"

namespace tw {

/// Particle shifting (Sun et al. 2017, doi:10.1016/j.cma.2016.10.028): particles move from where they are crowded to
/// where they are few,
///
///   s_i       = sum_j (1 + 0.2 (W_ij / W(dp))^4) grad_i W_ij V_j
///   delta x_i = -shifting dt max|u| h s_i,   at most 0.05 dp
///
/// The sum counts every neighbour: water, wall or air. `shifting` is 1 unless a scene says otherwise; the paper has
/// CFL Ma (2h)^2 where this has dt max|u| h.
struct Shifting {
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
};

/// Within 2h of a free surface shifting goes along it only: towards it, it would pump water up for ever (README). The
/// direction N_i = sum_j grad_i W_ij V_j over the neighbours j at the surface points towards it:
///
///   s_i -= (s_i . N_i) N_i / |N_i|^2
inline void keep_along_surface(const V3<float>& N, float N2, V3<float>& s) {
    if (!(N2 > 0)) return;
    const float share = (s.x * N.x + s.y * N.y + s.z * N.z) / N2;
    s.x -= share * N.x, s.y -= share * N.y, s.z -= share * N.z;
}

/// delta x_i from s_i, for one step.
struct ShiftStep {
    double factor;   ///< [m2]
    double longest;  ///< [m]

    ShiftStep(double shifting, double dt, double largest_speed, double h, double dp)
        : factor(-shifting * dt * std::max(largest_speed, 1e-30) * h), longest(0.05 * dp) {}

    struct Displacement {
        V3<double> x;    ///< [m]
        double length2;  ///< [m2]
    };
    Displacement of(float sx, float sy, float sz) const {
        V3<double> x{factor * double(sx), factor * double(sy), factor * double(sz)};
        const double length2 = dot(x, x), longest2 = longest * longest;
        if (length2 > longest2) x = (longest / std::sqrt(length2)) * x;
        return {x, std::min(length2, longest2)};
    }
};

}  // namespace tw
