#include "scene/particle_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/errors.h"
#include "scene/defaults.h"

namespace tw {

std::vector<Box> particle_zones(const Scene& scene) {
    constexpr double between = 10, from_openings = 8, infinite = std::numeric_limits<double>::infinity();
    std::vector<Box> zones;
    if (scene.sph.levels == 1) return zones;
    const auto refuse = [&](const std::string& why) {
        throw InputError(scene.place_of("sph.levels") + ": " + why);
    };
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream)
        refuse("several sizes of particles are for a hull in a stream so far; leave it out");
    const Box& domain = scene.domain.box;
    // of a dry bow what water may rise to
    Box hull = scene.hull->surface.bounds();
    if (!scene.hull->section)
        hull.min.x() = std::max(hull.min.x(), scene.hull->still.wet_bounds.min.x() - 0.25 * scene.hull->length);
    const double dp = scene.resolution.near_hull;
    double width = scene.sph.zone * dp;
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k), clear = from_openings * coarse_dp;
        Box box;
        for (int a = 0; a < 3; ++a) {
            box.min[a] = std::floor((hull.min[a] - width) / coarse_dp) * coarse_dp;
            box.max[a] = std::ceil((hull.max[a] + width) / coarse_dp) * coarse_dp;
        }
        for (int a = 1; a < 3; ++a) {
            if (box.min[a] < domain.min[a] + clear) box.min[a] = -infinite;
            if (box.max[a] > domain.max[a] - clear) box.max[a] = infinite;
        }
        box.max.z() = infinite;
        if (box.max.x() > domain.max.x() - clear) box.max.x() = infinite;
        box.min.x() = std::max(box.min.x(), domain.min.x() + clear);
        if (box.min.x() > hull.min.x() - from_openings * dp)
            refuse(fmt::format("particles of {:.4g} m do not fit between the inlet and the hull; fewer levels, or a "
                               "longer domain ahead",
                               coarse_dp));
        zones.insert(zones.begin(), box);
        width += between * coarse_dp;
    }
    return zones;
}

std::vector<double> particles_of_sizes(const Scene& scene) {
    constexpr double guards = 4.5;  // spacings
    const bool flat = scene.domain.dimensions == 2;
    Box water = scene.domain.box;
    water.max.z() = std::min(0.0, water.max.z());
    const double hull = water.volume() - water_volume(scene);
    const std::vector<Box> zones = particle_zones(scene);
    std::vector<double> counts;
    for (std::size_t k = 0; k <= zones.size(); ++k) {
        const double dp = std::ldexp(scene.resolution.near_hull, static_cast<int>(zones.size() - k));
        double volume = water_volume(scene);
        if (k > 0) {
            Box box = zones[k - 1];
            box.min = (box.min.array() - guards * dp).matrix().cwiseMax(water.min);
            box.max = (box.max.array() + guards * dp).matrix().cwiseMin(water.max);
            volume = box.volume() - hull;
        }
        counts.push_back(volume / (flat ? dp * dp * water.size().y() : dp * dp * dp));
    }
    return counts;
}

}  // namespace tw
