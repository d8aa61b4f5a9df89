#include "scene/defaults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/box/box_walls.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/oblique_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/water/capillary.h"
#include "scene/water/quiet_layer.h"
#include "scene/water/struck_plate.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"

namespace tw {
namespace {

double froude(const Hull& hull, double speed, double gravity) { return speed / std::sqrt(gravity * hull.length); }

/// Where the keel enters the still water; the bow for a hull whose forefoot is wet.
double keel_entry(const Hull& hull) { return hull.still.wet_bounds.min.x(); }

/// The hull's size across its length, for distances and sizes: a section has its length in that place, because the flow
/// cannot pass it sideways.
double breadth(const Hull& hull) { return hull.section ? hull.length : hull.beam; }

/// Lowest level whose cell does not exceed `cell`.
int level_for(double cell, double spacing) { return static_cast<int>(std::ceil(std::log2(spacing / cell) - 1e-9)); }

/// Heave of a free hull, roughly [s]: m w^2 (1 + a) = rho g L B, with as much added mass as mass (a = 1) and a
/// waterplane as long and wide as the hull; 0 of a hull that is held.
double heave_period(const Scene& scene) {
    if (!scene.hull_is_free() || !(scene.water.gravity > 0)) return 0;
    const double stiffness = scene.water.density * scene.water.gravity * scene.hull->length * scene.hull->beam;
    return 2 * std::numbers::pi * std::sqrt(2 * scene.hull->free->motion.mass.mass / stiffness);
}

/// When the stream has its speed, and a free hull is released [s].
double start_of(const Scene& scene) {
    return std::max(scene.motion.ramp, scene.hull_is_free() ? scene.hull->free->motion.release : 0);
}

/// Settling of a stream after its start [s]. Measured: the force of a planing hull is settled one L/U after the start
/// to within 2 %. A free hull heaves twice before it is steady.
double settling(const Scene& scene) {
    return std::max(time_scale(scene), start_up_period(scene)) + 2 * heave_period(scene);
}

}  // namespace

double default_near_hull(const Hull& hull) { return std::min(breadth(hull) / 20, hull.draft / 4); }

double coarsest_particles(const Hull& hull) { return 0.5 * std::min(hull.length, breadth(hull)); }

double snapped_spacing(double wish, double near_hull) {
    const double n = std::max(0.0, std::round(std::log2(wish / near_hull)));
    return near_hull * std::exp2(n);
}

double default_spacing(double near_hull, const Hull* hull) {
    if (!hull) return near_hull;
    const double n = std::floor(std::log2(hull->length / 12 / near_hull) + 1e-9);
    return near_hull * std::exp2(std::clamp(n, 0.0, 4.0));
}

Margins default_margins(const Hull& hull, double speed, double gravity) {
    const double L = hull.length, B = breadth(hull), top = hull.surface.bounds().max.z(),
                 bow = hull.surface.bounds().min.x();
    const double wavelength = 2 * std::numbers::pi * speed * speed / gravity;
    Margins m;
    // Measured: moving the inlet from 0.18 L to 0.43 L ahead of the keel's entry changed the lift by 0.4 %.
    m.ahead = std::max(0.15 * L, 0.6 * L - (keel_entry(hull) - bow));
    m.behind = L;
    // Measured: hard sides at 2 beams and a floor at 1.6 beams raise the lift by 5 %, at 1.5 and 1.2 beams by 12 %.
    m.side = 2 * B;
    // A submerged body's draft says how deep it is, not how large: three of its heights below it, as of a ship.
    const bool submerged = hull.surface.bounds().max.z() < 0;
    m.below = std::max(1.6 * B, submerged ? hull.draft + 3 * hull.surface.bounds().size().z() : 4 * hull.draft);
    if (froude(hull, speed, gravity) < 1) {
        m.side = std::max(m.side, 0.5 * L);
        m.below = std::max(m.below, std::min(0.5 * L, 0.5 * wavelength));
    }
    // Spray of a fast hull flies high: a quarter of the velocity head, at most one length.
    m.above = std::max({0.5 * L, top + 0.25 * L, std::min(L, 0.125 * speed * speed / gravity)});
    return m;
}

std::vector<RefinementBox> default_refinement(const Scene& scene) {
    const int finest = static_cast<int>(std::lround(std::log2(scene.resolution.spacing / scene.resolution.near_hull)));
    const double unscaled = scene.resolution.spacing / scene.resolution.scale;
    std::vector<RefinementBox> boxes;
    if (!scene.hull || scene.hull->section) return boxes;

    // Distances as fractions of length and beam, and the cells of each box, measured on the reference case (74 thousand
    // cells, lift within 0.5 % of a mesh that is fine all over): a box is never coarser than `cell`. The forces need no
    // more; spray and wake do, to be seen as the particles see them: at most `steps` halvings coarser than the finest.
    const Hull& hull = *scene.hull;
    const double L = hull.length, B = hull.beam, D = hull.draft;
    const Box bounds = hull.surface.bounds();
    const double entry = keel_entry(hull), bow = bounds.min.x(), stern = bounds.max.x();
    const double everywhere = 2 * scene.domain.box.size().maxCoeff();
    const auto add = [&](const std::string& name, int steps, double cell, Vec3 low, Vec3 high) {
        const int level = std::clamp(level_for(cell, unscaled), std::max(0, finest - steps), finest);
        Box box{low.cwiseMax(scene.domain.box.min), high.cwiseMin(scene.domain.box.max)};
        if (level > 0 && (box.size().array() > 0).all()) boxes.push_back({name, box, level});
    };
    // of a wave's height five cells at least, unless it has little way from the inlet
    const double cells = inlet_wave(scene) ? 1.5 : 5,
                 at_surface = scene.has_wave() ? std::min(L / 24, wave_scales(scene).height / cells) : L / 24;
    const int surface_level = std::clamp(level_for(at_surface, unscaled), std::max(0, finest - 3), finest);
    const double cell_there = scene.resolution.spacing / std::exp2(surface_level),
                 band = std::max(cell_there, scene.has_wave() ? 1.2 * wave_scales(scene).crest : 0);
    add("free_surface", 3, at_surface, {-everywhere, -everywhere, -band}, {everywhere, everywhere, band});
    add("wake", 2, L / 24, {bow - 0.2 * L, -1.7 * B, -D - 0.7 * B}, {stern + 1.125 * L, 1.7 * B, 0.7 * B});
    add("near", 1, L / 48, {entry - 0.23 * L, -B, -D - 0.25 * B}, {stern + 0.5 * L, B, 0.35 * B});
    add("wet", 1, B / 24, {entry - 0.08 * L, -0.62 * B, -D - 0.06 * B}, {stern + 0.09 * L, 0.62 * B, 0.12 * B});
    add("wet_bottom", 0, B / 48, {entry - 0.055 * L, -0.55 * B, -D - 0.035 * B},
        {stern + 0.025 * L, 0.55 * B, 0.06 * B});
    for (const RefinedPlace& place : scene.refined) {
        const int level = finest - place.halvings_short;
        for (std::size_t b = 0; b < place.boxes.size() && level > 0; ++b) {
            const Box box{place.boxes[b].min.cwiseMax(scene.domain.box.min),
                          place.boxes[b].max.cwiseMin(scene.domain.box.max)};
            const std::string part = place.boxes.size() > 1 ? std::to_string(b + 1) : "";
            if ((box.size().array() > 0).all()) boxes.push_back({place.name + part, box, level});
        }
    }
    std::stable_sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.level < b.level; });
    return boxes;
}

double time_scale(const Scene& scene) {
    if (scene.motion.kind == Motion::Kind::stream) {
        const double length = scene.hull ? scene.hull->length : scene.domain.as_asked.size().x();
        return length / scene.motion.speed;
    }
    if (scene.has_wave()) return wave_scales(scene).period;
    return std::sqrt(water_height(scene) / scene.water.gravity);
}

// Measured on the reference case: 0.15 s at L/U = 0.5 s.
double default_ramp(const Scene& scene) {
    // Weight drives water under a gate or over a weir from the first instant, so it has its speeds at once.
    return scene.motion.kind == Motion::Kind::stream && !tailwater(scene) ? 0.3 * time_scale(scene) : 0;
}

double start_up_period(const Scene& scene) {
    if (scene.motion.kind != Motion::Kind::stream || !scene.hull || !(scene.water.gravity > 0)) return 0;
    const double F = froude(*scene.hull, scene.motion.speed, scene.water.gravity);
    if (F >= 1) return 0;
    return 8 * std::numbers::pi * std::pow(std::min(F, 0.5), 2) * time_scale(scene);
}

/// Of the zone that makes the wave, in the scene's own sizes, whatever the run's scale [m].
double width_at_scale_one(Scene scene) {
    Resolution& r = scene.resolution;
    r.near_hull /= r.scale, r.spacing /= r.scale, r.scale = 1;
    const ZoneReach reach = zone_reach(scene, scene.water.gravity);
    return wave_scales(scene).comes_from_low_x ? reach.ahead : reach.behind;
}

/// From when on a tank's or a stream's wave has passed every gauge and body [s]. In a stream, and with solids in the
/// tank, it begins in the zone that makes it (scene/box/tank_wave.h), and its front runs to the other zone at the group
/// speed, over which the stream carries it. Until then a hull's flow has settled too.
double wave_has_passed(const Scene& scene) {
    const WaveScales wave = wave_scales(scene);
    if (scene.sea && scene.sea->kind == Sea::Kind::focused)  // what is measured is its crest
        return std::max(0.0, scene.sea->focus_time - 2 * wave.period);
    if (runs_obliquely(scene))
        return start_of(scene) + std::max(settling(scene), 3 * wave.period + time_to_fill(scene));
    if (scene.motion.kind == Motion::Kind::stream) {
        // Box and zones before they were rounded to the run's sizes: the same at all scales, as grid studies need it.
        const bool zones = scene.domain.box.size().x() > scene.domain.undamped.size().x();
        const double way = scene.domain.as_asked.size().x() + (zones ? width_at_scale_one(scene) : 0);
        return start_of(scene) + std::max(settling(scene), 3 * wave.period + way / wave.slowest);
    }
    const double way = begins_in_zone(scene) ? scene.domain.box.size().x() - wave.longest : 0;
    return 3 * wave.period + way / wave.slowest;
}

double default_duration(const Scene& scene) {
    const double T = time_scale(scene);
    if (scene.has_wave()) return wave_has_passed(scene) + std::max(wave_scales(scene).measured, start_up_period(scene));
    if (scene.motion.kind != Motion::Kind::stream) return 10 * T;
    // A section's jet falls back on the water before it and shakes the loads: twice the time for as good a mean.
    const double mean = scene.domain.dimensions == 2 ? 4 * T : 2 * T;
    return start_of(scene) + settling(scene) + std::max({mean, 3 * start_up_period(scene), 3 * heave_period(scene)});
}

bool loads_settle(const Scene& scene) {
    return scene.motion.kind == Motion::Kind::stream && scene.hull && !scene.hull->free && scene.bodies.empty() &&
           !scene.has_wave();
}

double default_interval(const Scene& scene) {
    const double T = time_scale(scene);
    return (scene.has_wave() ? std::min(T, wave_scales(scene).period) : T) / 25;
}

void fill_times(Scene& scene) {
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    const double T = time_scale(scene);
    // A run that ends when it has settled takes no more than it needs; its bound is for the slow ones.
    if (scene.run.duration == 0)
        scene.run.duration = (scene.run.stops_when_settled() ? 2 : 1) * default_duration(scene);
    if (scene.sampling.interval == 0) scene.sampling.interval = default_interval(scene);
    if (scene.sampling.mean_from == 0 && scene.has_wave()) scene.sampling.mean_from = wave_has_passed(scene);
    if (scene.sampling.mean_from == 0 && (stream || scene.hull))
        scene.sampling.mean_from = stream ? start_of(scene) + settling(scene) : 5 * T;
    if (scene.run.checkpoint == 0) scene.run.checkpoint = scene.run.duration / 20;
}

bool hull_held_in_stream(const Scene& scene) {
    return scene.motion.kind == Motion::Kind::stream && scene.hull && !scene.hull->free && !scene.hull->section &&
           scene.hull->surface.bounds().max.z() > 0 && scene.bodies.empty() && !scene.effect_on("viscosity") &&
           !scene.fvm.captures_geometrically();
}

int default_correctors(const Scene& scene) {
    // Measured: the loads on a held hull in a stream move by 0.1 % (docs/decisions/015-interfoam-settings.md); one
    // corrector is not stable on fine meshes.
    return hull_held_in_stream(scene) ? 2 : FvmOptions{}.correctors;
}

double speed_under_quiet_surface(const Scene& scene) {
    const QuietLayer layer = quiet_layer(scene);
    double speed = std::sqrt(2 * scene.water.gravity * (layer.surface - layer.bottom));
    for (const MovingBody& b : scene.bodies) {
        const SlowBody slow = slow_body(scene, b);
        speed = std::max(speed, std::sqrt(slow.dynamic / scene.water.density));
    }
    return speed;
}

double explained_speed(const Scene& scene) {
    if (scene.effect_on("dynamic_pressure")) return speed_under_quiet_surface(scene);
    // p_max / rho0 of the water at rest is g H; falling from the surface it reaches sqrt(2 g H).
    const std::optional<Tailwater> tail = tailwater(scene);
    // A planing hull's water does not fall to a floor that only ends its box.
    const bool no_bed = scene.hull && scene.domain.floor_ends_the_box && planes(scene);
    const double height = no_bed ? scene.hull->draft : std::max(water_height(scene), tail ? tail->depth : 0.0);
    const double fall = std::sqrt(2 * scene.water.gravity * height);
    double body = 0;
    for (const MovingBody& b : scene.bodies) body = std::max(body, b.fastest(scene.water.gravity));
    return std::max(
        {scene.motion.speed, tail ? tail->speed : 0.0, fall + fastest_wall(scene), body, capillary_speed(scene)});
}

double default_sound_speed(const Scene& scene) {
    return (water_strikes_plate(scene) ? sound_of_impact : 10) * explained_speed(scene);
}

RasterSpec default_raster(const Scene& scene, double spacing) {
    const Box& domain = scene.domain.undamped;
    Box region = domain;
    const bool flat = scene.domain.dimensions == 2;
    if (scene.hull && scene.motion.kind == Motion::Kind::stream && !flat) {  // a section's jet flies far ahead of it
        // From ahead of the spray root to the outlet, over the whole width (the wake opens), from below the trough
        // behind the transom, which fast hulls make deeper than their keels, to where connected spray can be.
        const Hull& hull = *scene.hull;
        const double L = hull.length, B = breadth(hull), top = hull.surface.bounds().max.z();
        region.min.x() = std::max(domain.min.x(), keel_entry(hull) - 0.25 * L);
        region.min.z() = std::max(domain.min.z(), -hull.draft - B);
        region.max.z() = std::min(domain.max.z(), std::max(0.5 * L, top + 0.25 * L));
    }
    RasterSpec raster;
    raster.voxel = spacing;
    for (int axis = 0; axis < 3; ++axis) {
        if (flat && axis == 1) {  // one voxel holds the whole thickness
            raster.origin[1] = domain.min.y();
            raster.count[1] = 1;
            continue;
        }
        // Voxel faces lie on multiples of the spacing, so that still water, z = 0, is one.
        const double low = std::floor(region.min[axis] / spacing + 1e-9);
        const double high = std::ceil(region.max[axis] / spacing - 1e-9);
        raster.origin[axis] = low * spacing;
        raster.count[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(std::round(high - low), 1.0, 2e9));
    }
    return raster;
}

double voxels(const RasterSpec& raster) {
    return static_cast<double>(raster.count[0]) * raster.count[1] * raster.count[2];
}

}  // namespace tw
