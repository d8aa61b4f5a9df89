#pragma once
#include <array>

#include "base/vec3.h"

namespace tw {

/// Six times the signed volume of the tetrahedron (a, b, c, p) [m3]: positive when p lies behind the triangle, i.e. on
/// the side its counter-clockwise normal points away from. Exactly 0 when the sign is below the rounding of the
/// evaluation (Shewchuk 1997, doi:10.1007/PL00009321, static filter), so a sign that is returned can be trusted.
double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

/// Sign of the turn a -> b -> p in the x-y plane: +1 left, -1 right; exact for all doubles. A point on the line is
/// moved by an infinitesimal (e, e^2) (simulation of simplicity, Edelsbrunner & Mücke 1990), so that the answer is 0
/// only when a and b have the same x and y, and a vertical ray never hits an edge.
int turn_in_plan(const Vec3& a, const Vec3& b, const Vec3& p);

/// +1 or -1 when a ray from p straight up leaves or enters the solid through the triangle, 0 when it misses.
/// Summed over a closed surface this is the winding number of p; no ray is counted twice or lost at edges.
int crossing_above(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

/// True when the segment p-q has a point in common with the closed triangle and is not in its plane.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

/// Distance along the unit direction `d` from `origin` to the triangle; a negative value when it is missed.
double ray_distance(const Vec3& origin, const Vec3& d, const Vec3& a, const Vec3& b, const Vec3& c);

/// What of a triangle lies nearest: its face, the edge from corner k to k + 1, or corner k.
enum class Feature { face, edge0, edge1, edge2, corner0, corner1, corner2 };
struct NearestOnTriangle {
    Vec3 point;  ///< [m]
    Feature feature;
};
/// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
NearestOnTriangle nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace tw
