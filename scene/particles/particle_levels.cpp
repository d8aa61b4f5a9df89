#include "scene/particles/particle_levels.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "base/errors.h"
#include "base/numbers.h"
#include "scene/box/box_walls.h"
#include "scene/refined_places.h"
#include "scene/water/afloat.h"
#include "scene/water/water_blocks.h"

namespace tw {

namespace {

/// Of the margin of a grid of distances beyond its zone: further than the buffers of the zone reach [coarse spacings].
constexpr double known_beyond = 8;
/// Of the grid of distances from a hull: of a run, and where particles are only counted.
constexpr double most_nodes = 5e6, most_counted_nodes = 5e5;

/// Spacings in a length of a run at `--scale` s over those at the scene's own size [-]. From 0.71 to 2 its zones are as
/// wide in metres as those of the scene, so that runs of several sizes are similar and the coarser ones cheap
/// (docs/decisions/031-levels.md); coarser ones keep half as many spacings, finer ones 1.41 times as many.
double narrowing(const Scene& scene) { return std::clamp(1 / scene.resolution.scale, 0.5, std::numbers::sqrt2); }
double between(const Scene& scene) { return 10 * narrowing(scene); }       ///< two edges [spacings of the level]
double from_openings(const Scene& scene) { return 8 * narrowing(scene); }  ///< of an edge, and boxes' [coarse spacings]

/// What finer particles stand round.
struct Root {
    Box box;
    bool moves = false;
};

/// What of the hull, with these bounds, the water may reach: of a dry bow what it may rise to, or of a hull that is
/// free dip to.
Box reached_hull(const Scene& scene, Box hull) {
    const double ahead = (scene.hull->free ? 0.5 : 0.25) * scene.hull->length;
    if (!scene.hull->section && scene.motion.kind == Motion::Kind::stream)
        hull.min.x() = std::max(hull.min.x(), scene.hull->still.wet_bounds.min.x() - ahead);
    return hull;
}

/// The solids: hull, obstacles, and bodies; what moves where `moving` says that it is.
std::vector<Root> roots(const Scene& scene, std::span<const MovedSolid> moving) {
    std::vector<Root> all;
    const bool free = scene.hull_is_free();
    if (scene.hull)
        all.push_back({reached_hull(scene, free ? moving.front().bounds : scene.hull->surface.bounds()), free});
    for (const Obstacle& o : scene.obstacles) all.push_back({o.surface.bounds()});
    for (const MovedSolid& body : moving.subspan(free ? 1 : 0)) all.push_back({body.bounds, true});
    return all;
}

/// A box of finer particles than `coarse_dp`, on the coarse lattice (unless it goes with a body), and through what is
/// too near to leave room. In a tank it goes on through the sky: a splash and a cavity stand above what makes them.
Box zone_box(const Root& what, double width, double coarse_dp, const Scene& scene) {
    const Box& domain = scene.domain.box;
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const double clear = (from_openings(scene) - 1e-3) * coarse_dp;  // less: faces of two lattices meet
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

/// A box of a zone, and the number of the solid or place that it stands round.
struct ZoneBox {
    Box box;
    std::size_t round;
};

/// Until the boxes round different things are at least `gap` apart or overlap: coarse particles need room between two
/// edges. A chain of boxes round one place is one piece.
void join_near(std::vector<ZoneBox>& boxes, double gap) {
    const auto near = [&](std::size_t i, std::size_t j) {
        const Box &a = boxes[i].box, &b = boxes[j].box;
        const double apart = (b.min - a.max).cwiseMax(a.min - b.max).maxCoeff();
        return boxes[i].round != boxes[j].round && apart > 0 && apart < gap;
    };
    const auto join = [&](std::size_t i, std::size_t j) {
        Box &a = boxes[i].box, &b = boxes[j].box;
        a = {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
    };
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (!near(i, j)) continue;
            join(i, j);
            // The larger box may be near one before it; boxes before it are as far from each other as they were.
            for (std::size_t k = 0; k < i; ++k) {
                if (!near(k, i)) continue;
                join(k, i);
                i = k, k = std::size_t(-1);
            }
            j = i;
        }
}

/// Whether zones are what is near the hull, and not a box round it.
bool follows_its_hull(const Scene& scene) {
    return scene.hull && !scene.hull->section && scene.motion.kind == Motion::Kind::stream;
}

/// Of the first box what is nearer to the hull at the start than `width`, and what lies behind that towards faces at
/// infinity.
Zone zone_near_hull(std::vector<Box> boxes, double width, double coarse_dp, const Scene& scene, double most) {
    const Box& first = boxes.front();
    const Box wet{first.min.cwiseMax(scene.domain.box.min), first.max.cwiseMin(scene.domain.box.max)};
    const double nodes_apart = sampling_distance(coarse_dp, wet.size(), most);
    auto near = std::make_shared<DistanceGrid>(scene.hull->surface, wet, nodes_apart, width + known_beyond * coarse_dp);
    for (int a = 0; a < 3; ++a) {
        if (std::isinf(first.min[a])) near->draw_out(a, false);
        if (std::isinf(first.max[a])) near->draw_out(a, true);
    }
    return Zone(std::move(boxes), std::move(near), width);
}

/// All that lies between the forcing zones, through walls, planes and the sky.
Box between_forcing_zones(const Scene& scene) {
    Box box = scene.domain.undamped;
    const Box& all = scene.domain.box;
    for (int a = 0; a < 3; ++a) {
        if (a == 2 || box.min[a] <= all.min[a]) box.min[a] = -infinite;
        if (a == 2 || box.max[a] >= all.max[a]) box.max[a] = infinite;
    }
    return box;
}

/// The boxes round the solids, the finest first: for each size one box a solid.
std::vector<std::vector<Box>> boxes_round(const std::vector<Root>& solids, const Scene& scene) {
    const double dp = scene.resolution.near_hull;
    double width = zone_width(scene);
    std::vector<std::vector<Box>> boxes;
    for (int k = 1; k < scene.sph.levels; ++k) {
        const double coarse_dp = std::ldexp(dp, k);
        std::vector<Box>& of_size = boxes.emplace_back();
        for (const Root& solid : solids) of_size.push_back(zone_box(solid, width, coarse_dp, scene));
        width += between(scene) * coarse_dp;
    }
    if (has_coarse_zones(scene)) boxes.push_back({between_forcing_zones(scene)});
    return boxes;
}

/// Whether coarser particles have no place left in the tank.
bool fills_the_domain(const Box& box, const Scene& scene) {
    const Box& domain = scene.domain.box;
    return box.contains(domain.min) && box.contains(domain.max);
}

/// How much the cells of particles may be stretched to fill a block of water. Runs at other sizes than the scene's are
/// to have as many sizes of particles as that, and there more is allowed: of 7 cells a half.
double most_stretch(const Scene& scene) { return scene.resolution.scale == 1 ? 0.02 : 0.07; }

/// Whether particles of `coarse_dp` fill each block of water to that share of its length, or to half a particle of
/// `dp`.
bool fills_the_water(const Scene& scene, double coarse_dp, double dp) {
    return std::ranges::all_of(blocks_of_water(scene), [&](const Box& block) {
        Eigen::Array3d size = block.size();
        if (scene.domain.dimensions == 2) size.y() = 0;
        const Eigen::Array3d missing = ((size / coarse_dp).round() * coarse_dp - size).abs();
        return (missing <= (most_stretch(scene) * size).max(0.5 * dp)).all();
    });
}

/// How many of those sizes have room: ahead of the solids and of one another in a stream, within the tank else.
int zones_that_fit(const Scene& scene, const std::vector<Root>& solids, const std::vector<std::vector<Box>>& boxes) {
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    int fit = scene.sph.levels - 1;  // the box between forcing zones is none round a solid
    for (std::size_t i = 0; i < solids.size(); ++i) {
        double x = solids[i].box.min.x(), dp = scene.resolution.near_hull;
        for (int k = 0; k < fit; ++k, dp *= 2) {
            const Box& box = boxes[static_cast<std::size_t>(k)][i];
            if (stream ? box.min.x() > x - from_openings(scene) * dp
                       : fills_the_domain(box, scene) || !fills_the_water(scene, 2 * dp, dp))
                fit = k;
            x = box.min.x();
        }
    }
    return fit;
}

/// The scene's own places, and the hull's wake.
std::vector<RefinedPlace> finer_places(const Scene& scene) {
    std::vector<RefinedPlace> places = scene.refined;
    if (scene.sph.wake == 0 || !follows_its_hull(scene)) return places;
    RefinedPlace& wake = places.emplace_back();
    wake.halvings_short = static_cast<int>(std::floor(std::log2(scene.sph.wake)));
    wake.boxes = {wake_of(
        scene, width_of_place * narrowing(scene) * std::ldexp(scene.resolution.near_hull, wake.halvings_short))};
    return places;
}

}  // namespace

double zone_width(const Scene& scene) {
    return std::max(scene.sph.zone * narrowing(scene), 8.0) * scene.resolution.near_hull;
}

double sampling_distance(double asked, const Vec3& size, double most) {
    const double volume = size.prod(), needed = std::cbrt(volume / most);
    double distance = asked * 10 < needed ? std::cbrt(volume * 50 / most) : std::max(asked, needed);
    // A box thinner than this has more places along its length than its volume tells.
    const Eigen::Array3d along = size;
    while ((along / distance).max(1).prod() > 2 * most) distance *= 2;
    return distance;
}

bool is_refined_unasked(const Scene& scene) {
    return follows_its_hull(scene) && !scene.hull->free && planes(scene) && scene.hull->surface.bounds().max.z() > 0;
}

namespace {

void keep_those_with_room(Scene& scene, const std::function<void()>& make_domain) {
    int& levels = scene.sph.levels;
    make_domain();
    while (levels > 1) {
        const std::vector<Root> all = roots(scene, moving_at_start(scene));
        const int fit = 1 + zones_that_fit(scene, all, boxes_round(all, scene));
        if (fit == levels) return;
        levels = fit;
        make_domain();
    }
}

}  // namespace

void follow_spacing(Scene& scene, const std::function<void()>& make_domain) {
    int& levels = scene.sph.levels;
    Resolution& r = scene.resolution;
    const bool elastic = std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.elastic.has_value(); });
    const bool solids = scene.hull || !scene.obstacles.empty() || !scene.bodies.empty();
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const bool follows = stream ? scene.hull.has_value() : solids && !elastic;
    r.of_particles = follows && r.spacing > r.near_hull && !scene.hull_is_free();
    if (follows && scene.sph.scheme == "kick_drift_kick" && !stream) make_domain();  // which says where the water is
    if (follows && scene.sph.scheme == "kick_drift_kick" && !carries_a_body(scene))
        levels = std::min(most_levels, 1 + static_cast<int>(std::lround(std::log2(r.spacing / r.near_hull))));
    if (!scene.places.contains("sph.wake") && follows_its_hull(scene) && scene.hull->surface.bounds().max.z() > 0)
        scene.sph.wake = 2;  // measured: docs/decisions/031-levels.md
    if (r.scale != 1) {      // as many as at the scene's own size, so that runs of several sizes are similar
        const Resolution scaled = r;
        r.near_hull /= r.scale, r.spacing /= r.scale, r.scale = 1;
        keep_those_with_room(scene, make_domain);
        r = scaled;
    }
    keep_those_with_room(scene, make_domain);
}

bool zones_move(const Scene& scene) {
    return (scene.hull_is_free() && !has_coarse_zones(scene)) || !scene.bodies.empty();
}

std::vector<MovedSolid> moving_at_start(const Scene& scene) {
    std::vector<MovedSolid> solids;
    if (scene.hull_is_free()) solids.push_back({scene.hull->surface.bounds()});
    for (const MovingBody& b : scene.bodies) solids.push_back({b.surface.bounds()});
    return solids;
}

namespace {

/// `most`: nodes of a grid of distances.
std::vector<Zone> zones_of(const Scene& scene, std::span<const MovedSolid> moving, std::span<const Zone> start,
                           double most) {
    const int below = sizes_below_near_hull(scene), finer = sizes_of_particles(scene) - 1;
    const std::vector<Root> solids = roots(scene, moving);
    const std::vector<std::vector<Box>> round = boxes_round(solids, scene);
    const std::vector<RefinedPlace> places = finer_places(scene);
    std::vector<Zone> zones;
    std::vector<double> reach(static_cast<std::size_t>(finer), 0.0);  // of a zone beyond the places of each size
    for (int k = 1; k <= finer; ++k) {
        const double coarse_dp = std::ldexp(finest_spacing(scene), k);
        std::vector<ZoneBox> boxes;
        if (k > below)
            for (const Box& box : round[static_cast<std::size_t>(k - below - 1)]) boxes.push_back({box, boxes.size()});
        for (std::size_t p = 0; p < places.size(); ++p) {
            const RefinedPlace& place = places[p];
            if (place.halvings_short + below >= k) continue;
            for (const Box& part : place.boxes) {
                const double more = reach[static_cast<std::size_t>(place.halvings_short + below)];
                const Box box = zone_box({part}, more, coarse_dp, scene);
                if (box.min.x() < box.max.x()) boxes.push_back({box, solids.size() + p});
            }
        }
        const Box first = boxes.front().box;
        join_near(boxes, from_openings(scene) * coarse_dp);
        std::vector<Box> parts;
        for (const ZoneBox& b : boxes) parts.push_back(b.box);
        const bool alone = k > below && first.min == parts.front().min && first.max == parts.front().max;
        const bool is_whole_box = has_coarse_zones(scene) && k == finer;
        if (!alone || !follows_its_hull(scene) || is_whole_box) {
            zones.insert(zones.begin(), Zone(std::move(parts)));
        } else if (start.empty()) {
            const double width = zone_width(scene) + reach[static_cast<std::size_t>(below)];
            zones.insert(zones.begin(), zone_near_hull(std::move(parts), width, coarse_dp, scene, most));
        } else {
            zones.insert(zones.begin(),
                         Zone(std::move(parts), start[static_cast<std::size_t>(finer - k)],
                              scene.hull_is_free() ? moving.front().way : Eigen::Isometry3d::Identity()));
        }
        for (int size = 0; size < k && size < finer; ++size)
            reach[static_cast<std::size_t>(size)] += between(scene) * coarse_dp;
    }
    return zones;
}

/// At the start. Throws InputError.
std::vector<Zone> zones_at_start(const Scene& scene, double most) {
    if (sizes_of_particles(scene) == 1) return {};
    const auto refuse = [&](const std::string& why) { throw InputError(scene.place_of("sph.levels") + ": " + why); };
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const std::vector<MovedSolid> moving = moving_at_start(scene);
    const std::vector<Root> solids = roots(scene, moving);
    if (has_coarse_zones(scene)) {
        if (scene.sph.levels > 1 || !scene.bodies.empty())
            throw InputError(scene.place_of("sph.zones") +
                             ": coarse particles in forcing zones go with one size in the box, and with no body in it; "
                             "write zones = \"fine\"");
        if (scene.domain.box.min == scene.domain.undamped.min && scene.domain.box.max == scene.domain.undamped.max)
            throw InputError(scene.place_of("sph.zones") +
                             ": this scene has no forcing zones outside its box; remove this key");
    } else if (solids.empty() || (stream && !scene.hull))
        refuse("several sizes of particles stand round a hull, an obstacle or a body; leave it out");
    if (const int fit = zones_that_fit(scene, solids, boxes_round(solids, scene)); fit + 1 < scene.sph.levels)
        refuse(stream
                   ? fmt::format("particles of {:.4g} m do not fit between the inlet and the hull; at most {} here, "
                                 "or a longer domain ahead",
                                 std::ldexp(scene.resolution.near_hull, fit + 1), fit + 1)
                   : fmt::format("particles of {:.4g} m have no room in this tank, or fill its water only to more than "
                                 "{:.0f} % of its length; at most {} here",
                                 std::ldexp(scene.resolution.near_hull, fit + 1), 100 * most_stretch(scene), fit + 1));
    return zones_of(scene, moving, {}, most);
}

}  // namespace

std::vector<Zone> particle_zones(const Scene& scene) { return zones_at_start(scene, most_nodes); }

std::vector<Zone> zones_to_count(const Scene& scene) { return zones_at_start(scene, most_counted_nodes); }

std::vector<Zone> particle_zones(const Scene& scene, std::span<const MovedSolid> moving, std::span<const Zone> start) {
    return zones_of(scene, moving, start, most_nodes);
}

}  // namespace tw
