#pragma once
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

}  // namespace tw
