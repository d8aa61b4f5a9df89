#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

/// Particles of one size: those that are the water of their zone, and those that stand for water of the next larger
/// and the next smaller size.
struct ParticlesOfSize {
    double spacing = 0, active = 0, guards = 0, parents = 0;  ///< [m]; numbers of particles [-]
    double all() const { return active + guards + parents; }
};
/// When particles are counted. Only water that runs into finer zones makes a difference (running_water.h).
enum class During {
    start,  ///< with the water where it stands then
    mean,   ///< of the run
    peak    ///< the most at a time, for memory
};
/// How many particles each size takes, coarsest first.
std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene, During when = During::mean);
double all_of(const std::vector<ParticlesOfSize>& sizes);

}  // namespace tw
