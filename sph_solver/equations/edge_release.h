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
template <class Real>
struct EdgeRelease {
    V3<Real> e;  ///< zero: no edge
    Real s;
    void apply(V3<Real>& a) const { a -= s * positive_part(dot(a, e)) * e; }
};

/// s_i; `speed2`: w_i^2, above zero.
inline float released_share(float p, float rho0, float speed2) {
    const float share = 1 - p / (0.5f * rho0 * speed2);
    return share < 0 ? 0 : share > 1 ? 1 : share;
}

}  // namespace tw
