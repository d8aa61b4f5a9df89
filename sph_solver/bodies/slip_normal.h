#pragma once
#include <optional>

#include "meshes/query.h"

namespace tw {

/// The exterior unit normal along which a slip wall acts on water of velocity `u` [m/s] whose nearest wall point is
/// `nearest`: the wall's velocity in the continuity sum is u - (u . n) n.
///
/// On a face it is the face's normal. At an edge or corner it points from there to the water, as long as the water
/// comes nearer. For water that leaves, that direction would make the edge a wall which moves off with the water and
/// pulls: a suction behind every transom and chine. Such water slides off the face that it flows along, so there it is
/// the normal, of the faces that meet, that the water follows least.
Vec3 slip_normal(const SurfaceQuery& query, const SurfaceQuery::Nearest& nearest, const Vec3& u);

/// When water at `x` of velocity `u` [m/s], past a face `found` of the surface, comes beyond a sharp edge in which that
/// face ends [s]; none: not within the way `reach` [m].
std::optional<double> time_to_edge(const SurfaceQuery& query, const SurfaceQuery::Nearest& found, const Vec3& x,
                                   const Vec3& u, double reach);

}  // namespace tw
