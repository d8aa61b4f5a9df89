#include "scene/water/water_blocks.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_boxes.h"
#include "scene/water/tailwater.h"

namespace tw {

double water_height(const Scene& scene) {
    const double floor = scene.domain.as_asked.min.z();
    if (scene.water_blocks.empty()) return -floor;
    double top = floor;
    for (const Box& block : scene.water_blocks) top = std::max(top, block.max.z());
    return top - floor;
}

std::vector<Box> blocks_of_water(const Scene& scene) {
    if (!scene.water_blocks.empty())
        return disjoint_boxes(scene.water_blocks, scene.domain.dimensions, 0.5 * scene.resolution.near_hull);
    Box water = scene.domain.box;
    water.max.z() = std::min(0.0, water.max.z());
    const auto tail = tailwater(scene);
    if (!tail) return {water};
    const double dp = scene.resolution.near_hull;
    Box behind = water;
    water.max.x() = behind.min.x() = std::round(tail->begins / dp) * dp;
    behind.max.z() = std::round(tail->level / dp) * dp;
    return {water, behind};
}

double water_volume(const Scene& scene) {
    if (!scene.water_blocks.empty()) {
        double volume = 0;
        for (const Box& block : blocks_of_water(scene)) volume += block.volume();
        return volume;
    }
    const Vec3 size = scene.domain.box.size();
    const double hull = scene.hull ? scene.hull->still.volume * scene.span() / scene.symmetry_factor() : 0;
    double bodies = 0;
    for (const MovingBody& b : scene.bodies) bodies += hydrostatics(b.surface).volume * scene.span();
    double water = size.x() * size.y() * -scene.domain.box.min.z();
    if (tailwater(scene)) {
        water = 0;
        for (const Box& block : blocks_of_water(scene)) water += block.volume();
    }
    return water - hull - bodies;
}

double air_volume(const Scene& scene) {
    double taken = water_volume(scene);
    if (scene.hull) taken += scene.hull->mass.volume * scene.span() / scene.symmetry_factor();
    for (const Obstacle& o : scene.obstacles) taken += mass_properties(o.surface).volume;
    for (const MovingBody& b : scene.bodies) taken += mass_properties(b.surface).volume * scene.span();
    return std::max(0.0, scene.domain.box.volume() - taken);
}

}  // namespace tw
