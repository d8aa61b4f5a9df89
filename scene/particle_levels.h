#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

/// Where the particles of each finer size stand, the widest first: a box round what of the hull the water may reach,
/// with faces at infinity where the zone goes on through the sky, a wall, a symmetry plane or the outlet, because no
/// coarser particles fit between. Box faces lie on the coarse lattice. Edges are ten spacings of the level between them
/// apart, and eight of the coarser side from the inlet. Empty with `[sph] levels = 1`. Throws InputError where there is
/// no hull in a stream, or no room ahead of it.
std::vector<Box> particle_zones(const Scene& scene);

/// How many particles each size takes, coarsest first: those of its zone, the guards round it, and those of a finer
/// zone that stand for finer particles.
std::vector<double> particles_of_sizes(const Scene& scene);

}  // namespace tw
