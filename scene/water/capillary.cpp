#include "scene/water/capillary.h"

#include <cmath>
#include <numbers>

#include "scene/water/water_blocks.h"

namespace tw {

double capillary_speed(const Scene& scene) {
    if (!scene.effect_on("surface_tension")) return 0;
    const double h = scene.sph.h_over_dp * scene.resolution.near_hull;
    return std::sqrt(4 * scene.water.surface_tension / (scene.water.density * h));
}

double surface_energy(const Scene& scene) {
    if (!scene.effect_on("surface_tension")) return 0;
    const bool flat = scene.domain.dimensions == 2;
    const Box& tank = scene.domain.box;
    const double slack = 1e-6 * tank.size().maxCoeff();
    double area = 0, volume = 0;
    bool on_wall = false;
    for (const Box& block : blocks_of_water(scene)) {
        volume += block.volume();
        for (int a = 0; a < 3; ++a) {
            if (a == 1 && flat) continue;
            for (const bool high : {false, true}) {
                const double gap = high ? tank.max[a] - block.max[a] : block.min[a] - tank.min[a];
                if (gap > slack)
                    area += block.volume() / block.size()[a];
                else
                    on_wall = true;
            }
        }
    }
    const double span = scene.domain.box.size().y();
    const double least = on_wall ? 0
                         : flat  ? 2 * std::sqrt(std::numbers::pi * volume * span)
                                 : std::cbrt(36 * std::numbers::pi * volume * volume);
    return scene.water.surface_tension * std::max(0.0, area - least);
}

}  // namespace tw
