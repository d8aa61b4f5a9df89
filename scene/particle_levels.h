#pragma once
#include <functional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace tw {

/// Where the particles of each finer size stand at the start, the widest zone first, each a union of boxes: the first
/// round the solids (of a hull in a stream round what the water may reach), then those that the scene asks for
/// ([[refine]]). Faces are at infinity where a zone goes on through the sky, a wall, a symmetry plane or the outlet,
/// because no coarser particles fit between; others lie on the coarse lattice, but for boxes round bodies that move.
/// Edges are ten spacings of the level between them apart, and eight of the coarser side from the inlet; boxes with
/// less than eight between them become one. Empty with `[sph] levels = 1`. Throws InputError where there is no solid,
/// or no room ahead of it or within the tank.
std::vector<std::vector<Box>> particle_zones(const Scene& scene);
/// The same with the bodies that move in these boxes, in the scene's order; asks nothing.
std::vector<std::vector<Box>> particle_zones(const Scene& scene, std::span<const Box> moving);

/// Gives the particles round the scene's solids the sizes between its near_hull and its spacing: as many as there may
/// be, and as have room in the domain that `make_domain` makes for them. Without a solid one size is left. The domain
/// is made in any case.
void follow_spacing(Scene& scene, const std::function<void()>& make_domain);

/// Particles of one size: those that are the water of their zone, and those that stand for water of the next larger
/// and the next smaller size.
struct ParticlesOfSize {
    double spacing = 0, active = 0, guards = 0, parents = 0;
    double all() const { return active + guards + parents; }
};
/// How many particles each size takes, coarsest first.
std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene);

}  // namespace tw
