#include "scene/particle_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "base/errors.h"
#include "scene/defaults.h"

namespace tw {

namespace {

constexpr double between = 10, from_openings = 8;  ///< spacings
constexpr double infinite = std::numeric_limits<double>::infinity();

/// What finer particles stand round.
struct Root {
    Box box;
    bool moves = false;
};

/// What of the hull the water may reach: of a dry bow what it may rise to.
Box reached_hull(const Scene& scene) {
    Box hull = scene.hull->surface.bounds();
    if (!scene.hull->section && scene.motion.kind == Motion::Kind::stream)
        hull.min.x() = std::max(hull.min.x(), scene.hull->still.wet_bounds.min.x() - 0.25 * scene.hull->length);
    return hull;
}

/// The solids: hull, obstacles, and bodies that move where `moving` says that they are.
std::vector<Root> roots(const Scene& scene, std::span<const Box> moving) {
    std::vector<Root> all;
    if (scene.hull) all.push_back({reached_hull(scene)});
    for (const Obstacle& o : scene.obstacles) all.push_back({o.surface.bounds()});
    for (const Box& box : moving) all.push_back({box, true});
    return all;
}

std::vector<Box> bodies_at_start(const Scene& scene) {
    std::vector<Box> boxes;
    for (const MovingBody& b : scene.bodies) boxes.push_back(b.surface.bounds());
    return boxes;
}

/// A box of finer particles than `coarse_dp`, on the coarse lattice (unless it goes with a body), and through what is
/// too near to leave room. In a tank it goes on through the sky: a splash and a cavity stand above what makes them.
Box zone_box(const Root& what, double width, double coarse_dp, const Scene& scene) {
    const Box& domain = scene.domain.box;
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const double clear = from_openings * coarse_dp;
    Box box{what.box.min - Vec3::Constant(width), what.box.max + Vec3::Constant(width)};
    if (!what.moves) {
        box.min = (box.min / coarse_dp).array().floor() * coarse_dp;
        box.max = (box.max / coarse_dp).array().ceil() * coarse_dp;
    }
    for (int a = stream ? 1 : 0; a < 3; ++a) {
        if (box.min[a] < domain.min[a] + clear) box.min[a] = -infinite;
        if (box.max[a] > domain.max[a] - clear) box.max[a] = infinite;
    }
    if (!stream || box.max.z() > -clear) box.max.z() = infinite;
    if (!stream) return box;
    if (box.max.x() > domain.max.x() - clear) box.max.x() = infinite;
    box.min.x() = std::max(box.min.x(), domain.min.x() + clear);
    return box;
}

/// Until all boxes are at least `gap` apart or overlap: coarse particles need room between two edges.
void join_near(std::vector<Box>& boxes, double gap) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            const Vec3 apart = (boxes[j].min - boxes[i].max).cwiseMax(boxes[i].min - boxes[j].max);
            const double most = apart.maxCoeff();
            if (most <= 0 || most >= gap) continue;
            boxes[i] = {boxes[i].min.cwiseMin(boxes[j].min), boxes[i].max.cwiseMax(boxes[j].max)};
            boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
            return join_near(boxes, gap);
        }
}

/// Volume of a union of boxes.
double volume_of(const std::vector<Box>& boxes) {
    std::array<std::vector<double>, 3> cuts;
    for (std::size_t a = 0; a < 3; ++a) {
        for (const Box& box : boxes) cuts[a].insert(cuts[a].end(), {box.min[int(a)], box.max[int(a)]});
        std::ranges::sort(cuts[a]);
    }
    double sum = 0;
    for (std::size_t i = 1; i < cuts[0].size(); ++i)
        for (std::size_t j = 1; j < cuts[1].size(); ++j)
            for (std::size_t k = 1; k < cuts[2].size(); ++k) {
                const Box cell{Vec3(cuts[0][i - 1], cuts[1][j - 1], cuts[2][k - 1]),
                               Vec3(cuts[0][i], cuts[1][j], cuts[2][k])};
                const Vec3 middle = 0.5 * (cell.min + cell.max);
                if (std::ranges::any_of(boxes, [&](const Box& box) { return box.contains(middle); }))
                    sum += cell.volume();
            }
    return sum;
}

/// The boxes round the solids, the finest first: for each size one box a solid.
std::vector<std::vector<Box>> boxes_round(const std::vector<Root>& solids, const Scene& scene) {
    const double dp = scene.resolution.near_hull;
    double width = scene.sph.zone * dp;
    std::vector<std::vector<Box>> boxes;
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k);
        std::vector<Box>& of_size = boxes.emplace_back();
        for (const Root& solid : solids) of_size.push_back(zone_box(solid, width, coarse_dp, scene));
        width += between * coarse_dp;
    }
    return boxes;
}

/// Whether coarser particles have no place left in the tank.
bool fills_the_domain(const Box& box, const Scene& scene) {
    const Box& domain = scene.domain.box;
    return box.contains(domain.min) && box.contains(domain.max);
}

/// The blocks of water at the start, solids in them included.
std::vector<Box> blocks_of_water(const Scene& scene) {
    if (!scene.water_blocks.empty()) return scene.water_blocks;
    Box water = scene.domain.box;
    water.max.z() = std::min(0.0, water.max.z());
    return {water};
}

/// Whether each block of water is a whole number of particles of `coarse_dp` long, to half a particle of `dp`.
bool divides_the_water(const Scene& scene, double coarse_dp, double dp) {
    return std::ranges::all_of(blocks_of_water(scene), [&](const Box& block) {
        Vec3 size = block.size();
        if (scene.domain.dimensions == 2) size.y() = 0;
        return ((size / coarse_dp).array().round() * coarse_dp - size.array()).abs().maxCoeff() <= 0.5 * dp;
    });
}

/// How many of those sizes have room: ahead of the solids and of one another in a stream, within the tank else.
int zones_that_fit(const Scene& scene, const std::vector<Root>& solids, const std::vector<std::vector<Box>>& boxes) {
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    int fit = static_cast<int>(boxes.size());
    for (std::size_t i = 0; i < solids.size(); ++i) {
        double x = solids[i].box.min.x(), dp = scene.resolution.near_hull;
        for (int k = 0; k < fit; ++k, dp *= 2) {
            const Box& box = boxes[static_cast<std::size_t>(k)][i];
            if (stream ? box.min.x() > x - from_openings * dp
                       : fills_the_domain(box, scene) || !divides_the_water(scene, 2 * dp, dp))
                fit = k;
            x = box.min.x();
        }
    }
    return fit;
}

}  // namespace

void follow_spacing(Scene& scene, const std::function<void()>& make_domain) {
    int& levels = scene.sph.levels;
    const Resolution& r = scene.resolution;
    const bool elastic = std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.elastic.has_value(); });
    const bool solids = scene.hull || !scene.obstacles.empty() || !scene.bodies.empty();
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    if ((stream ? scene.hull.has_value() : solids && !elastic) && scene.sph.scheme == "kick_drift_kick")
        levels = std::min(most_levels, 1 + static_cast<int>(std::lround(std::log2(r.spacing / r.near_hull))));
    make_domain();
    while (levels > 1) {
        const std::vector<Root> all = roots(scene, bodies_at_start(scene));
        const int fit = 1 + zones_that_fit(scene, all, boxes_round(all, scene));
        if (fit == levels) return;
        levels = fit;
        make_domain();
    }
}

std::vector<std::vector<Box>> particle_zones(const Scene& scene, std::span<const Box> moving) {
    const double dp = scene.resolution.near_hull;
    std::vector<std::vector<Box>> round = boxes_round(roots(scene, moving), scene), zones;
    // how far a zone reaches beyond the places of each size
    std::vector<double> width(static_cast<std::size_t>(scene.sph.levels), 0.0);
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k);
        std::vector<Box>& boxes = round[static_cast<std::size_t>(k - 1)];
        for (const RefinedPlace& place : scene.refined)
            if (place.halvings_short < k) {
                double& reach = width[static_cast<std::size_t>(place.halvings_short)];
                const Box box = zone_box({place.box}, reach, coarse_dp, scene);
                if (box.min.x() < box.max.x()) boxes.push_back(box);
            }
        join_near(boxes, from_openings * coarse_dp);
        zones.insert(zones.begin(), boxes);
        for (int size = 0; size < k; ++size) width[static_cast<std::size_t>(size)] += between * coarse_dp;
    }
    return zones;
}

std::vector<std::vector<Box>> particle_zones(const Scene& scene) {
    if (scene.sph.levels == 1) return {};
    const auto refuse = [&](const std::string& why) { throw InputError(scene.place_of("sph.levels") + ": " + why); };
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const std::vector<Box> moving = bodies_at_start(scene);
    const std::vector<Root> solids = roots(scene, moving);
    if (solids.empty() || (stream && !scene.hull))
        refuse("several sizes of particles stand round a hull, an obstacle or a body; leave it out");
    if (const int fit = zones_that_fit(scene, solids, boxes_round(solids, scene)); fit + 1 < scene.sph.levels)
        refuse(stream ? fmt::format("particles of {:.4g} m do not fit between the inlet and the hull; at most {} here, "
                                    "or a longer domain ahead",
                                    std::ldexp(scene.resolution.near_hull, fit + 1), fit + 1)
                      : fmt::format("particles of {:.4g} m have no room in this tank, or do not divide its water into "
                                    "whole particles; at most {} here",
                                    std::ldexp(scene.resolution.near_hull, fit + 1), fit + 1));
    return particle_zones(scene, moving);
}

namespace {

/// Where bodies are that go half their way with their first velocity, at most as far as the domain goes.
std::vector<Box> bodies_half_way(const Scene& scene) {
    std::vector<Box> boxes = bodies_at_start(scene);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        if (scene.bodies[b].motion.law) continue;
        const Box& domain = scene.domain.box;
        const Vec3 way = (0.5 * scene.run.duration * scene.bodies[b].motion.velocity)
                             .cwiseMax(0.5 * (domain.min - boxes[b].min))
                             .cwiseMin(0.5 * (domain.max - boxes[b].max));
        boxes[b] = {boxes[b].min + way, boxes[b].max + way};
    }
    return boxes;
}

}  // namespace

std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene) {
    constexpr double guards = 4.5;  // spacings
    const bool flat = scene.domain.dimensions == 2;
    const std::vector<Box> blocks = blocks_of_water(scene);
    const double span = scene.domain.box.size().y(), solids = volume_of(blocks) - water_volume(scene);
    std::vector<std::vector<Box>> zones = particle_zones(scene);
    if (!zones.empty() && !scene.bodies.empty()) zones = particle_zones(scene, bodies_half_way(scene));
    const auto water_within = [&](const std::vector<Box>& boxes, double further) {
        std::vector<Box> wet;
        for (const Box& box : boxes)
            for (const Box& block : blocks) {
                const Box both{(box.min.array() - further).matrix().cwiseMax(block.min),
                               (box.max.array() + further).matrix().cwiseMin(block.max)};
                if ((both.size().array() > 0).all()) wet.push_back(both);
            }
        return std::max(0.0, volume_of(wet) - solids);
    };
    std::vector<ParticlesOfSize> sizes;
    for (std::size_t k = 0; k <= zones.size(); ++k) {
        ParticlesOfSize& size = sizes.emplace_back();
        const double dp = size.spacing = std::ldexp(scene.resolution.near_hull, static_cast<int>(zones.size() - k));
        const double particle = flat ? dp * dp * span : dp * dp * dp;
        const double own = k > 0 ? water_within(zones[k - 1], 0) : water_volume(scene),
                     finer = k < zones.size() ? water_within(zones[k], 0) : 0;
        size.active = (own - finer) / particle;
        size.parents = finer / particle;
        if (k > 0) size.guards = (water_within(zones[k - 1], guards * dp) - own) / particle;
    }
    return sizes;
}

}  // namespace tw
