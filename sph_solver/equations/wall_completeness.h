#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Whether a wall touches the water at a particle: how full the kernel's half towards the wall is. With the wall's
/// exterior unit normal n_i at the particle,
///
///   T_i = 2 sum_j chi_ij V_j W_ij,   chi_ij = clamp(1/2 - r_ji . n_i / dp, 0, 1),   r_ji = x_j - x_i
///
/// over the particle itself, water and wall. It is 1 where there is no void between water and wall, however near a free
/// surface is on the other side: so a film is touched as deep water is. A void of width g takes 2 g W_1(dp/2) from it,
/// W_1 the kernel integrated over planes: 0.08 at g = dp/10 with h = 1.55 dp.
struct WallCompleteness {
    float inv_dp;    ///< 2h / dp, for lengths in 2h [-]
    float inv_void;  ///< 1 / (1 - touch_support) [-]

    /// One neighbour's part of T_i / W_over_G.
    template <class Real, class Form>
    void add(const Pair<Real, Form>& ij, const V3<Real>& n_i, Real& sum) const {
        const Real from_below = positive_part(0.5f - inv_dp * dot(ij.r_ji, n_i));
        const Real chi = from_below - positive_part(from_below - 1.0f);
        sum += 2.0f * chi * ij.V_W();
    }

    /// A wall compresses only the water that it touches: what comes nearer through a void closes the void first.
    /// Receding walls pull at once. Of the walls' part d of div u therefore
    ///
    ///   d >= 0:  d clamp((T_i - T_0) / (1 - T_0), 0, 1),   d < 0:  d,   T_0 = touch_support
    template <class Real>
    Real compression(const Real& d, const Real& touch) const {
        const Real void_share = positive_part(1.0f - touch) * inv_void;
        return d + positive_part(d) * (positive_part(1.0f - void_share) - 1.0f);
    }
};

}  // namespace tw
