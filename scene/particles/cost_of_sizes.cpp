#include "scene/particles/cost_of_sizes.h"

#include <cmath>

namespace tw {

std::vector<CostOfSize> cost_of_sizes(const Scene& scene, const Prediction& p, const MethodCost& cost) {
    const std::vector<ParticlesOfSize> mean = particles_of_sizes(scene);
    const std::vector<ParticlesOfSize> most =
        p.most_particles == p.particles ? mean : particles_of_sizes(scene, During::peak);
    std::vector<CostOfSize> sizes;
    for (const ParticlesOfSize& particles : mean) sizes.emplace_back().particles = particles;
    const double in_memory = p.most_particles + p.wall_particles;
    double visits = 0;  // of particles in a step of the finest size
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        CostOfSize& size = sizes[k];
        const bool finest = k + 1 == sizes.size();
        const double steps_of_finest = std::exp2(sizes.size() - 1 - k);
        const double walls = finest ? p.wall_particles : 0, all = size.particles.all() + walls;
        size.dt = scene.run.duration / cost.steps / std::exp2(k);
        size.bytes = (cost.bytes - p.raster_bytes) * (most[k].all() + walls) / in_memory;
        visits += size.seconds = all / steps_of_finest;
    }
    for (CostOfSize& size : sizes) size.seconds *= cost.seconds / visits;
    return sizes;
}

}  // namespace tw
