#include "scene/read/domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/box/box_walls.h"
#include "scene/box/forcing_zones.h"
#include "scene/defaults.h"
#include "scene/refined_places.h"

namespace tw {
namespace {

/// A face that the user gave goes to the nearest multiple of the largest particle spacing, one that follows from the
/// hull outward to a multiple of the largest cell too. Still water, z = 0, is a multiple of both. A floor that was
/// given stays where it is: particles and cells are made to fit the depth.
double snapped_face(double face, bool given, bool high, const Scene& scene) {
    const Resolution& r = scene.resolution;
    const double dp = largest_particles(scene);
    if (given) return std::round(face / dp) * dp;
    const double size = std::max(r.spacing, dp);
    return (high ? std::ceil(face / size - 1e-6) : std::floor(face / size + 1e-6)) * size;
}

/// Measured: in boxes that by the formula change a planing hull's lift by one per cent, boxes twice as large changed it
/// by 2 to 4 (docs/decisions/089-two-depths-and-coarse-zones.md).
constexpr double beyond_formula = 1.5;

/// Where coarser particles far away make room cheap, a box twice as large changes a planing hull's loads by at most 2 %.
Margins margins(const Scene& scene) {
    const Hull& hull = *scene.hull;
    Margins m = default_margins(hull, scene.motion.speed, scene.water.gravity);
    const bool several_sizes = scene.resolution.of_particles || scene.sph.levels > 1;
    if (!several_sizes || !planes(scene) || hull.section) return m;
    const WallReach reach = reach_for_lift(hull, 0.01);
    m.side = std::max(m.side, beyond_formula * reach.side), m.below = std::max(m.below, beyond_formula * reach.depth);
    if (!hull.free) m.ahead += 0.8 * hull.length;  // where the zones of twice the sizes, a coarser member's, have room
    return m;
}

/// Moves the faces of a hull's box away from the hull, but for the sides of a channel; the floor at most to the bed,
/// `deepest` below still water.
void widen(Box& box, const Box& hull, double factor, double deepest, bool channel) {
    box.min.x() = hull.min.x() - factor * (hull.min.x() - box.min.x());
    box.max.x() = hull.max.x() + factor * (box.max.x() - hull.max.x());
    if (!channel) box.min.y() *= factor, box.max.y() *= factor;
    if (-box.min.z() < deepest) box.min.z() = -std::min(factor * -box.min.z(), deepest);
}

/// The box as asked and as it is solved; the rest of the domain is left at its defaults.
Domain stream_domain(const DomainOptions& o, const Scene& scene, std::optional<double> water_depth, double box_factor) {
    Box box;
    bool floor_given = o.z || o.below;
    if (scene.hull) {
        const Box hull = scene.hull->surface.bounds();
        const Margins m = margins(scene);
        const double side = o.side.value_or(m.side);
        const double below = o.below.value_or(std::min(water_depth.value_or(m.below), m.below));
        // A wave is that of the depth asked for, at every size.
        floor_given = floor_given || (water_depth && *water_depth <= m.below) || scene.has_wave();
        box.min = {hull.min.x() - o.ahead.value_or(m.ahead), -side, -below};
        box.max = {hull.max.x() + o.behind.value_or(m.behind), side, o.above.value_or(m.above)};
    }
    if (o.x) std::tie(box.min.x(), box.max.x()) = *o.x;
    if (o.y) std::tie(box.min.y(), box.max.y()) = *o.y;
    if (o.z) std::tie(box.min.z(), box.max.z()) = *o.z;
    if (scene.hull && scene.hull->half) box.min.y() = 0;
    Domain d;
    const double deepest = water_depth.value_or(std::numeric_limits<double>::infinity());
    const bool open_water = scene.hull && scene.motion.kind == Motion::Kind::stream;
    d.floor_ends_the_box = open_water && -box.min.z() < deepest;
    if (open_water && box_factor != 1)
        widen(box, scene.hull->surface.bounds(), box_factor, deepest, sides_are_meant(scene));
    d.as_asked = box;
    const bool low_given[] = {o.x || o.ahead, o.y || o.side, floor_given};
    const bool high_given[] = {o.x || o.behind, o.y || o.side, o.z || o.above};
    for (int axis = 0; axis < 3; ++axis) {
        if (axis != 2 || !floor_given) box.min[axis] = snapped_face(box.min[axis], low_given[axis], false, scene);
        box.max[axis] = snapped_face(box.max[axis], high_given[axis], true, scene);
    }
    d.box = box;
    return d;
}

/// Moves the faces outward by what the scene's forcing zones take.
void add_zones(Domain& d, const Scene& before, Sections& s) {
    Scene scene = before;
    scene.domain = d;
    const double gravity = s.effects.on_off("gravity").value_or(true) ? scene.water.gravity : 0;
    if (!(gravity > 0) || !s.effects.on_off("forcing_zones").value_or(has_zones_by_default(scene, gravity))) return;
    const ZoneReach reach = zone_reach(scene, gravity);
    d.box.min.x() -= reach.ahead;
    d.box.max.x() += reach.behind;
    d.box.max.y() += reach.side;
    if (d.y_min != Side::symmetry) d.box.min.y() -= reach.side;
}

/// Of a half model the part at y > 0 is solved.
void check_half_range(double low, double high, SceneSection& s, const std::string& key) {
    if (!(high > 0) || (low != 0 && low != -high))
        s.fail(key,
               fmt::format("a half model is solved from y = 0 on, and here y runs from {:.6g} to {:.6g} m; expected y "
                           "from 0, or the same distance to both sides",
                           low, high));
}

}  // namespace

Resolution resolution_of(const ResolutionOptions& o, const Hull* hull, SceneSection& s, double scale) {
    Resolution r;
    if (!o.near_hull && !o.spacing && !hull)
        s.fail("near_hull", "missing; a scene without a hull needs its particle spacing, e.g. near_hull = \"0.02 m\"");
    if (o.near_hull)
        r.near_hull = *o.near_hull;
    else
        r.near_hull = hull ? default_near_hull(*hull) : *o.spacing;
    if (!o.near_hull && o.spacing) r.near_hull = std::min(r.near_hull, *o.spacing);
    // Two dimensions have cells of one size.
    const Hull* refined = hull && !hull->section ? hull : nullptr;
    r.spacing = o.spacing ? snapped_spacing(*o.spacing, r.near_hull) : default_spacing(r.near_hull, refined);
    r.near_hull *= scale;
    r.spacing *= scale;
    r.scale = scale;
    return r;
}

void check_sizes(const Resolution& r, std::initializer_list<double> lengths, const char* of_what, SceneSection& s) {
    const auto refuse = [&](const std::string& key, double size, double length, double most) {
        s.fail(key, fmt::format(
                        "too coarse: {:.4g} m{}, but {} is only {:.4g} m wide or long; expected at most {:.3g} m", size,
                        r.scale == 1 ? "" : fmt::format(" with --scale {:g}", r.scale), of_what, length, most));
    };
    const double shortest = std::min(lengths), longest = std::max(lengths);
    if (r.near_hull > 0.5 * shortest)
        refuse(s.has("near_hull") || !s.has("spacing") ? "near_hull" : "spacing", r.near_hull, shortest,
               0.5 * shortest);
    if (r.spacing > longest) refuse("spacing", r.spacing, longest, longest);
}

Domain domain_of(const DomainOptions& o, const std::optional<Box>& tank, const Scene& scene, Sections& s,
                 std::optional<double> depth, double box_factor) {
    Domain d;
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    if (tank) {
        if (stream)
            s.tank.fail("size",
                        "a tank has walls all round and no stream; use [domain] for a stream, or kind = \"none\"");
        if (!o.empty()) s.domain.fail("x", "[tank] already says how large the domain is; keep one of the two");
        d.box = *tank;
        if (scene.hull && scene.hull->half) {
            check_half_range(d.box.min.y(), d.box.max.y(), s.tank, s.tank.has("size") ? "size" : "min");
            d.box.min.y() = 0;
        }
        d.as_asked = d.box;
    } else {
        if (scene.hull && scene.hull->half && o.y) check_half_range(o.y->first, o.y->second, s.domain, "y");
        if (!scene.hull && !(o.x && o.z && (o.y || o.dimensions == 2)))
            s.domain.fail(stream ? "x" : "size",
                          "missing; a scene without a hull needs [domain] x, y and z ranges, or a [tank]");
        d = stream_domain(o, scene, depth, box_factor);
    }
    d.dimensions = o.dimensions;
    if (!scene.hull) {
        const Vec3 size = d.as_asked.size();
        check_sizes(scene.resolution, {size.x(), o.dimensions == 2 ? size.x() : size.y(), size.z()},
                    tank ? "the tank" : "the domain", s.resolution);
    }
    if (o.dimensions == 2) {
        d.box.max.y() = 0.5 * scene.resolution.near_hull;  // one particle thick, round the plane y = 0
        d.box.min.y() = -d.box.max.y();
        d.as_asked.min.y() = d.as_asked.max.y() = 0;
    }
    if (stream) {
        d.x_min = Side::inlet;
        d.x_max = Side::outlet;
    }
    if (scene.hull && scene.hull->half) d.y_min = Side::symmetry;
    if (o.dimensions == 2) d.y_min = d.y_max = Side::symmetry;
    d.undamped = d.box;
    if (stream) add_zones(d, scene, s);
    return d;
}

}  // namespace tw
