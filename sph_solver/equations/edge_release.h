#pragma once
#include "sph_solver/equations/vector.h"

namespace tw {

/// Water that has slid off a wall's edge into the open (behind a dry transom, beside a chine) is not driven along its
/// way by the dummies that it has left. Of the wall's part a of its acceleration
///
///   a_i <- a_i - s_i max(0, a_i . e_i) e_i,   s_i = clamp(1 - p_i / (rho0 w_i^2 / 2), 0, 1)
///
/// for particles beyond an edge that lack support, e_i the direction and w_i the speed of their way past the wall. A
/// wall without friction presses along its normals only, and does no work on water that passes it. In the pair sums the
/// parts along a wall cancel between particles before and behind each of its dummies; at an edge those behind it are
/// left over: a push of about p h for each metre of edge, on the water downstream and on the body as thrust.
///
/// Where water surrounds the edge its own pairs balance the wall's and nothing may be taken: there the support is full,
/// or, beside a void deep in the water, p_i is large. Water in the open has little pressure for its speed.
///
/// Water that comes up to a dry edge has dummies behind it and none before it. What a pressure that is the same all
/// round, p_i, adds to the pair sums along the way is not balanced: a push of p h / 2 towards the edge, which is taken
/// away,
///
///   a_i <- a_i - s_i v_i max(0, b_i . e_i) e_i,   b_i = -2 p_i / rho_i sum_d grad_i W_id V_d,
///   v_i = clamp((1 - S_i) / 0.02, 0, 1)
///
/// so that the wall acts along the way by the differences of pressure in it, as if it went on. v_i: whether there is
/// nothing beyond the edge. Of a dry edge the void takes 0.07 of the support half a spacing before it, 0.03 a spacing.
template <class Real>
struct EdgeRelease {
    V3<Real> w;  ///< velocity past the wall, along e; zero: no edge
    Real share;  ///< s_i / w^2 beyond the edge, -s_i v_i / w^2 before it, else zero
    /// `uniform`: b_i . w_i
    void apply(V3<Real>& a, const Real& uniform) const {
        a -= (positive_part(share) * positive_part(dot(a, w)) + positive_part(-share) * positive_part(uniform)) * w;
    }
};
/// v_i.
inline float void_beyond(float support) {
    const float share = (1 - support) / 0.02f;
    return share < 0 ? 0 : share > 1 ? 1 : share;
}

/// s_i; `speed2`: w_i^2, above zero.
inline float released_share(float p, float rho0, float speed2) {
    const float share = 1 - p / (0.5f * rho0 * speed2);
    return share < 0 ? 0 : share > 1 ? 1 : share;
}

}  // namespace tw
