#pragma once
#include <vector>

#include "scene/particles/particles_of_sizes.h"

namespace tw {

/// What one of several sizes of particles takes of a predicted run.
struct CostOfSize {
    ParticlesOfSize particles;      ///< in the mean
    double bytes = 0, seconds = 0;  ///< its parts of memory (without the water raster) [bytes] and time [s]
    double dt = 0;                  ///< time step [s]
};

/// Of particles, coarsest first; `cost`: of their run. Each size steps half as often as the next smaller one; walls are counted with the finest.
std::vector<CostOfSize> cost_of_sizes(const Scene& scene, const Prediction& prediction, const MethodCost& cost);

}  // namespace tw
