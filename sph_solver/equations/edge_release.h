#pragma once
#include "sph_solver/equations/vector.h"

namespace tw {

/// Water that has slid off a wall's edge into the open (behind a dry transom, beside a chine) is no longer driven along
/// its way by the dummies that it has left: of the wall's part a of its acceleration
///
///   a_i <- a_i - max(0, a_i . e_i) e_i
///
/// is taken, e_i the direction in which it leaves, for particles beyond an edge that lack support. A wall without
/// friction presses along its normals only, and does no work on water that passes it. In the pair sums the parts along
/// a wall cancel between particles before and behind each of its dummies; at an edge those behind it are left over: a
/// push of about p h for each metre of edge, on the water downstream and on the body as thrust.
///
/// Zero e_i: no edge, nothing is taken. Where water surrounds the edge its own pairs balance the wall's, so full
/// support leaves the sum as it is.
template <class Real>
struct EdgeRelease {
    V3<Real> e;
    void apply(V3<Real>& a) const { a -= positive_part(dot(a, e)) * e; }
};

}  // namespace tw
