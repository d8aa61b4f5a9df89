#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

/// Particles of one size: those that are the water of their zone, and those that stand for water of the next larger
/// and the next smaller size.
struct ParticlesOfSize {
    double spacing = 0, active = 0, guards = 0, parents = 0;
    double all() const { return active + guards + parents; }
};
/// How many particles each size takes, coarsest first.
std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene);

}  // namespace tw
