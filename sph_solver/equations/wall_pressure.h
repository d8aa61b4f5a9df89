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

}  // namespace tw
