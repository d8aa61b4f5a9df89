#pragma once
#include "sph_solver/equations/pair.h"

namespace tw {

/// Pressure at a point (a wall's dummy, a sample on a surface) from the water round it, with the force that holds the
/// wall's acceleration a_d (Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005):
///
///   p_d = sum_f (p_f + rho_f (g - a_d) . (x_d - x_f)) V_f W_df / sum_f V_f W_df
struct WallPressure {
    /// Below this support the point has lost the water: a hundredth of that at a plane wall.
    static constexpr float least_support = 0.005f;

    /// The fluid's pressure carried to the point; `g_minus_a` times 2h. With r_ji = x_f - x_d.
    template <class Real, class Form, class G>
    static Real carried(const Pair<Real, Form>& ij, float p_f, float rho_f, const V3<G>& g_minus_a) {
        return p_f - rho_f * dot(g_minus_a, ij.r_ji);
    }
};

/// A wall compresses only the water that it touches: while the kernel support S_i is incomplete there is a void between
/// them, and the void closes first. Receding walls pull at once. Of the walls' part of div u therefore
///
///   d >= 0:  d clamp((S_i - S_touch) / (1 - S_touch), 0, 1),   d < 0:  d
///
/// `inv_void` is 1 / (1 - S_touch).
template <class Real>
inline Real compression_by_walls(const Real& d, const Real& support, float inv_void) {
    const Real void_share = positive_part(1.0f - support) * inv_void;
    const Real touch = positive_part(1.0f - void_share);
    return d + positive_part(d) * (touch - 1.0f);
}

}  // namespace tw
