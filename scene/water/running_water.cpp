#include "scene/water/running_water.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshes/mass_properties.h"
#include "scene/refined_places.h"
#include "scene/water/water_blocks.h"

namespace tw {

double solids_below(const Scene& scene, double z) {
    const auto below = [z](Surface surface) {
        for (Vec3& p : surface.points) p.z() -= z;
        return hydrostatics(surface).volume;
    };
    double sum = scene.hull ? below(scene.hull->surface) * scene.span() / scene.symmetry_factor() : 0;
    for (const Obstacle& o : scene.obstacles) sum += below(o.surface);
    for (const MovingBody& b : scene.bodies) sum += below(b.surface) * scene.span();
    return sum;
}

std::optional<RunningWater> running_water(const Scene& scene) {
    if (scene.water_blocks.empty() || !(scene.water.gravity > 0)) return {};
    const Box& tank = scene.domain.box;
    const double floor = tank.min.z(), area = tank.volume() / tank.size().z(), water = water_volume(scene),
                 top = std::ranges::max_element(scene.water_blocks, {}, [](const Box&b) { return b.max.z(); })->max.z();
    double low = floor, high = tank.max.z();
    while (high - low > 1e-9 * tank.size().z()) {
        const double z = std::midpoint(low, high);
        (area * (z - floor) - solids_below(scene, z) < water ? low : high) = z;
    }
    if (top - high <= 0.5 * finest_spacing(scene)) return {};
    return RunningWater{high, std::min(2 * high - floor, top)};
}

}  // namespace tw
