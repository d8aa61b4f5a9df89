#include "scene/particles/particles_of_sizes.h"

#include <algorithm>
#include <cmath>

#include "scene/particles/particle_levels.h"
#include "scene/refined_places.h"
#include "scene/water/running_water.h"
#include "scene/water/water_blocks.h"

namespace tw {

namespace {

/// Where bodies are that go half their way with their first velocity, at most as far as the domain goes.
std::vector<MovedSolid> bodies_half_way(const Scene& scene) {
    const Box& domain = scene.domain.box;
    std::vector<MovedSolid> solids;
    for (const MovingBody& b : scene.bodies) {
        Box& box = solids.emplace_back(MovedSolid{b.surface.bounds()}).bounds;
        if (b.motion.law) continue;
        const Vec3 way = (0.5 * scene.run.duration * b.motion.velocity)
                             .cwiseMax(0.5 * (domain.min - box.min))
                             .cwiseMin(0.5 * (domain.max - box.max));
        box = {box.min + way, box.max + way};
    }
    return solids;
}

/// Places inside a box, of which each stands for `volume`.
struct Sampled {
    double volume = 0;
    std::vector<Vec3> places;
};
Sampled sampled(const Box& box, double spacing) {
    constexpr double most = 2e6;
    spacing = sampling_distance(spacing, box.size(), most);
    const Eigen::Array3d count = (box.size() / spacing).array().round().max(1);
    const Vec3 cell = box.size().array() / count;
    Sampled s{cell.prod(), {}};
    for (double k = 0.5; k < count.z(); ++k)
        for (double j = 0.5; j < count.y(); ++j)
            for (double i = 0.5; i < count.x(); ++i) s.places.push_back(box.min + Vec3(i, j, k).cwiseProduct(cell));
    return s;
}

/// Volume of what is nearer to the zone than `further`, of the blocks of water.
double volume_near(const Zone& zone, double further, const std::vector<Box>& blocks, double spacing) {
    Box bounds = zone.boxes().front();
    for (const Box& box : zone.boxes()) bounds = {bounds.min.cwiseMin(box.min), bounds.max.cwiseMax(box.max)};
    double sum = 0;
    for (const Box& block : blocks) {
        const Box both{(bounds.min.array() - further).matrix().cwiseMax(block.min),
                       (bounds.max.array() + further).matrix().cwiseMin(block.max)};
        if ((both.size().array() <= 0).any()) continue;
        const Sampled s = sampled(both, spacing);
        sum += s.volume *
               double(std::ranges::count_if(s.places, [&](const Vec3& x) { return zone.outside(x) < further; }));
    }
    return sum;
}

/// With the water in these blocks, of which `solids` [m3] is none.
std::vector<ParticlesOfSize> counted(const Scene& scene, const std::vector<Zone>& zones, const std::vector<Box>& blocks,
                                     double solids) {
    constexpr double guards = 4.5;  // spacings
    const double all = water_volume(scene);
    const bool flat = scene.domain.dimensions == 2;
    std::vector<ParticlesOfSize> sizes;
    double own = all;
    for (std::size_t k = 0; k <= zones.size(); ++k) {
        ParticlesOfSize& size = sizes.emplace_back();
        const double dp = size.spacing = std::ldexp(finest_spacing(scene), static_cast<int>(zones.size() - k));
        const double particle = flat ? dp * dp * scene.domain.box.size().y() : dp * dp * dp;
        const auto water_within = [&](const Zone& zone, double further, double spacing) {
            return std::clamp(volume_near(zone, further, blocks, spacing) - solids, 0.0, all);
        };
        const double finer = k < zones.size() ? water_within(zones[k], 0, dp) : 0;
        size.active = (own - finer) / particle;
        size.parents = finer / particle;
        if (k > 0) size.guards = (water_within(zones[k - 1], guards * dp, 2 * dp) - own) / particle;
        own = finer;
    }
    return sizes;
}

}  // namespace

std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene, During when) {
    std::vector<Zone> zones = zones_to_count(scene);
    if (!zones.empty() && !scene.bodies.empty()) zones = particle_zones(scene, bodies_half_way(scene), zones);
    const auto at_start = [&] {
        const std::vector<Box> blocks = blocks_of_water(scene);
        double solids = -water_volume(scene);
        for (const Box& block : blocks) solids += block.volume();
        return counted(scene, zones, blocks, solids);
    };
    const std::optional<RunningWater> running =
        zones.empty() || when == During::start ? std::nullopt : running_water(scene);
    if (!running) return at_start();
    Box filled = scene.domain.box;
    filled.max.z() = when == During::mean ? running->level : running->highest;
    std::vector<ParticlesOfSize> sizes = counted(scene, zones, {filled}, solids_below(scene, filled.max.z()));
    if (when == During::mean) return sizes;
    std::vector<ParticlesOfSize> start = at_start();
    return all_of(start) > all_of(sizes) ? start : sizes;
}

double all_of(const std::vector<ParticlesOfSize>& sizes) {
    double sum = 0;
    for (const ParticlesOfSize& size : sizes) sum += size.all();
    return sum;
}

}  // namespace tw
