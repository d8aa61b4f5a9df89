#pragma once
#include <functional>
#include <span>
#include <vector>

#include "meshes/moved_solid.h"
#include "meshes/zone.h"
#include "scene/scene.h"

namespace tw {

/// Where the particles of each finer size stand at the start, the widest zone first: what is near a three-dimensional
/// hull in a stream, as far as the water may reach, and its wake ([sph] wake); boxes round other solids; boxes that the
/// scene asks for ([[refine]]), which alone may hold particles finer than near_hull. Faces are at infinity where a zone
/// goes on through the sky, a wall, a symmetry plane or the outlet, because no coarser particles fit between; others of
/// boxes lie on the coarse lattice, but for those round what moves. Edges are ten spacings of the level between them
/// apart, and eight of the coarser side from the inlet; boxes with less than eight between them become one; at scales
/// from 0.71 to 2 these lengths and zone_width are those of scale 1. Where
/// forcing zones have coarse particles the box without these zones is the widest. Empty where particles have one size.
/// Throws InputError where there is no solid, or no room ahead of it or within the tank.
std::vector<Zone> particle_zones(const Scene& scene);
/// The same where particles are only counted: beside a large hull by a tenth of the distances, which take most of the
/// time of a prediction.
std::vector<Zone> zones_to_count(const Scene& scene);
/// The first with what moves where it is now: a hull that is free, then bodies, in the scene's order. `start`: the
/// zones at the start, whose distances from the hull go with it. Asks nothing.
std::vector<Zone> particle_zones(const Scene& scene, std::span<const MovedSolid> moving, std::span<const Zone> start);
/// Width of the finest zone round a solid [m].
double zone_width(const Scene& scene);
/// Whether zones go with something that moves; what that is, as it stands at the start.
bool zones_move(const Scene& scene);
std::vector<MovedSolid> moving_at_start(const Scene& scene);

/// Whether a scene that does not write its spacing has particles of several sizes: where they follow a hull that is
/// held in a stream, at planing speeds, for which their forces were compared with those of one size.
bool is_refined_unasked(const Scene& scene);

/// Gives the particles round the scene's solids the sizes between its near_hull and its spacing: as many as there may
/// be, and as have room in the domain that `make_domain` makes for them (one where a body floats, afloat.h; at another
/// scale no more than at the scene's own); and those in the wake of a hull that crosses the surface the default of
/// `[sph] wake`. Without a solid one size is left. The domain is made in any case.
void follow_spacing(Scene& scene, const std::function<void()>& make_domain);

/// Between places that sample a box of this size [m]: as `asked` [m], unless that makes more than `most` places (twice
/// as many in a box thinner than the distance). Where it makes a thousand times as many, no machine holds the
/// particles, and a fiftieth of `most` tells how far from that they are.
double sampling_distance(double asked, const Vec3& size, double most);

}  // namespace tw
