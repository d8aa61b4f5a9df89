#include "scene/particle_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/errors.h"
#include "scene/defaults.h"

namespace tw {

namespace {

constexpr double between = 10, from_openings = 8;  ///< spacings
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A box of finer particles than `coarse_dp`, on the coarse lattice, and through what is too near to leave room.
Box zone_box(const Box& what, double width, double coarse_dp, const Box& domain) {
    const double clear = from_openings * coarse_dp;
    Box box;
    for (int a = 0; a < 3; ++a) {
        box.min[a] = std::floor((what.min[a] - width) / coarse_dp) * coarse_dp;
        box.max[a] = std::ceil((what.max[a] + width) / coarse_dp) * coarse_dp;
    }
    for (int a = 1; a < 3; ++a) {
        if (box.min[a] < domain.min[a] + clear) box.min[a] = -infinite;
        if (box.max[a] > domain.max[a] - clear) box.max[a] = infinite;
    }
    if (box.max.z() > -clear) box.max.z() = infinite;
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

/// What of the hull the water may reach: of a dry bow what it may rise to.
Box reached_hull(const Scene& scene) {
    Box hull = scene.hull->surface.bounds();
    if (!scene.hull->section)
        hull.min.x() = std::max(hull.min.x(), scene.hull->still.wet_bounds.min.x() - 0.25 * scene.hull->length);
    return hull;
}

/// The boxes round the hull, the finest first.
std::vector<Box> hull_zones(const Scene& scene) {
    const double dp = scene.resolution.near_hull;
    double width = scene.sph.zone * dp;
    std::vector<Box> boxes;
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k);
        boxes.push_back(zone_box(reached_hull(scene), width, coarse_dp, scene.domain.box));
        width += between * coarse_dp;
    }
    return boxes;
}

/// How many of those boxes leave room ahead of the hull and of one another.
int zones_that_fit(const Scene& scene, const std::vector<Box>& boxes) {
    double x = reached_hull(scene).min.x(), dp = scene.resolution.near_hull;
    int fit = 0;
    for (const Box& box : boxes) {
        if (box.min.x() > x - from_openings * dp) break;
        x = box.min.x(), dp *= 2, ++fit;
    }
    return fit;
}

}  // namespace

void follow_spacing(Scene& scene, const std::function<void()>& make_domain) {
    int& levels = scene.sph.levels;
    const Resolution& r = scene.resolution;
    if (scene.hull && scene.motion.kind == Motion::Kind::stream && scene.sph.scheme == "kick_drift_kick")
        levels = std::min(most_levels, 1 + static_cast<int>(std::lround(std::log2(r.spacing / r.near_hull))));
    make_domain();
    for (int fit = 0; levels > 1 && (fit = 1 + zones_that_fit(scene, hull_zones(scene))) < levels; make_domain())
        levels = fit;
}

std::vector<std::vector<Box>> particle_zones(const Scene& scene) {
    std::vector<std::vector<Box>> zones;
    if (scene.sph.levels == 1) return zones;
    const auto refuse = [&](const std::string& why) {
        throw InputError(scene.place_of("sph.levels") + ": " + why);
    };
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream)
        refuse("several sizes of particles are for a hull in a stream so far; leave it out");
    const Box& domain = scene.domain.box;
    const double dp = scene.resolution.near_hull;
    const std::vector<Box> round_hull = hull_zones(scene);
    if (const int fit = zones_that_fit(scene, round_hull); fit + 1 < scene.sph.levels)
        refuse(fmt::format("particles of {:.4g} m do not fit between the inlet and the hull; at most {} here, or a "
                           "longer domain ahead",
                           std::ldexp(dp, fit + 1), fit + 1));
    // how far a zone reaches beyond the places of each size
    std::vector<double> width(static_cast<std::size_t>(scene.sph.levels), 0.0);
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k);
        std::vector<Box> boxes{round_hull[static_cast<std::size_t>(k - 1)]};
        for (const RefinedPlace& place : scene.refined)
            if (place.halvings_short < k) {
                double& reach = width[static_cast<std::size_t>(place.halvings_short)];
                const Box box = zone_box(place.box, reach, coarse_dp, domain);
                if (box.min.x() < box.max.x()) boxes.push_back(box);
            }
        join_near(boxes, from_openings * coarse_dp);
        zones.insert(zones.begin(), boxes);
        for (int size = 0; size < k; ++size) width[static_cast<std::size_t>(size)] += between * coarse_dp;
    }
    return zones;
}

std::vector<ParticlesOfSize> particles_of_sizes(const Scene& scene) {
    constexpr double guards = 4.5;  // spacings
    const bool flat = scene.domain.dimensions == 2;
    Box water = scene.domain.box;
    water.max.z() = std::min(0.0, water.max.z());
    const double hull = water.volume() - water_volume(scene);
    const std::vector<std::vector<Box>> zones = particle_zones(scene);
    const auto water_within = [&](std::vector<Box> boxes, double further) {
        for (Box& box : boxes) {
            box.min = (box.min.array() - further).matrix().cwiseMax(water.min);
            box.max = (box.max.array() + further).matrix().cwiseMin(water.max);
        }
        return volume_of(boxes) - hull;
    };
    std::vector<ParticlesOfSize> sizes;
    for (std::size_t k = 0; k <= zones.size(); ++k) {
        ParticlesOfSize& size = sizes.emplace_back();
        const double dp = size.spacing = std::ldexp(scene.resolution.near_hull, static_cast<int>(zones.size() - k));
        const double particle = flat ? dp * dp * water.size().y() : dp * dp * dp;
        const double own = k > 0 ? water_within(zones[k - 1], 0) : water_volume(scene),
                     finer = k < zones.size() ? water_within(zones[k], 0) : 0;
        size.active = (own - finer) / particle;
        size.parents = finer / particle;
        if (k > 0) size.guards = (water_within(zones[k - 1], guards * dp) - own) / particle;
    }
    return sizes;
}

}  // namespace tw
