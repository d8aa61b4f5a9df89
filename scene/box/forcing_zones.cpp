#include "scene/box/forcing_zones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/box/box_walls.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/oblique_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/refined_places.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"
#include "waves/dispersion.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr double ahead_of_wave = 1, behind_of_wave = 1.5, side_of_wave = 0.5;  ///< widths over lambda
constexpr double fewest_spacings = 8;  ///< of the largest size, in which a blending is still resolved

/// From the bottom of the box to still water, as asked for: the same at every resolution.
double depth_of(const Scene& scene) { return -scene.domain.as_asked.min.z(); }

double largest_size(const Scene& scene) { return std::max(scene.resolution.spacing, largest_particles(scene)); }

/// The narrowest zone, and the shortest wave that one is made for [m].
double shortest_wave(const Scene& scene) { return fewest_spacings * largest_size(scene); }

bool has_open_sides(const Scene& scene) {
    return scene.hull && scene.domain.dimensions == 3 && scene.zones.sides == "open" && !scene.has_wave();
}

/// The water at an end of a stream.
struct Running {
    double speed, depth;  ///< [m/s], [m]
    double share = 1;     ///< of the stream's speed
};
Running ahead_of(const Scene& scene) { return {scene.motion.speed, depth_of(scene)}; }
Running behind_of(const Scene& scene) {
    const auto tail = tailwater(scene);
    return tail ? Running{tail->speed, tail->depth, tail->speed / scene.motion.speed} : ahead_of(scene);
}

/// The wave for which a zone is made; above the critical speed, where they are there on demand only, that of deep
/// water.
double wave_of(const Running& water, double gravity) {
    return standing_wave_length(water.speed, gravity, water.depth)
        .value_or(2 * pi * water.speed * water.speed / gravity);
}

/// Whether an end has a zone: not where water comes or goes above the critical speed to another depth, and none is
/// asked for.
bool has_zone(const Running& water, const Scene& scene, double gravity) {
    return !tailwater(scene) || standing_wave_length(water.speed, gravity, water.depth);
}

constexpr double longest_of_hull = 1.5;  ///< wave over hull length, of length Froude number 0.49

/// Whether the stream's own waves ask for zones; a planing hull leaves its waves behind.
bool waves_stand(const Scene& scene, double gravity) {
    return !(scene.hull && planes(scene)) &&
           (tailwater(scene) || standing_wave_length(scene.motion.speed, gravity, depth_of(scene)));
}

/// The longest wave for which zones are not too large beside the box [m]; in two dimensions they cost little.
double longest_wave(const Scene& scene) {
    if (!scene.hull) return 0.5 * scene.domain.as_asked.size().x();
    return scene.hull->section ? INFINITY : longest_of_hull * scene.hull->length;
}

std::string why_of_two_depths(const Scene& scene) {
    const auto end = [&](const Running& water) {
        const auto wave = standing_wave_length(water.speed, scene.water.gravity, water.depth);
        return fmt::format(
            "{:.4g} m deep with {:.4g} m/s, {}", water.depth, water.speed,
            wave ? fmt::format("where a wave of {:.3g} m stands", *wave) : "faster than its waves, without a zone");
    };
    return fmt::format("ahead the water is {}; behind {}", end(ahead_of(scene)), end(behind_of(scene)));
}

std::string why_in_stream(const Scene& scene, double wave) {
    const double U = scene.motion.speed, g = scene.water.gravity, h = depth_of(scene);
    std::string why = standing_wave_length(U, g, h)
                          ? fmt::format("a wave of {:.3g} m stands in this stream (Froude number of depth {:.2f})",
                                        wave, U / std::sqrt(g * h))
                          : fmt::format(
                                "no wave stands in this stream (Froude number of depth {:.2f}); they are as "
                                "asked for, for the {:.3g} m of deep water",
                                U / std::sqrt(g * h), wave);
    if (const double most = longest_wave(scene); wave > most)
        why +=
            fmt::format("; they are as wide as for {:.3g} m, {}", most,
                        scene.hull ? fmt::format("{:g} hull lengths", longest_of_hull) : "half the channel's length");
    if (const double least = shortest_wave(scene); wave < least)
        why += fmt::format("; they are made for {:.3g} m, {:g} of the largest spacings", least, fewest_spacings);
    if (scene.has_wave() && !runs_obliquely(scene) && scene.hull && scene.domain.dimensions == 3)
        why += "; the sides are walls: zones there would take the wave";
    else if (scene.hull && scene.domain.dimensions == 3 && scene.zones.sides == "walls")
        why += "; the sides are walls, as [domain] sides says";
    return why;
}

/// A width in whole ones of the largest size, so many at least that a blending is resolved [m].
double in_whole_sizes(const Scene& scene, double width) {
    const double size = largest_size(scene);
    return std::ceil(std::max(width / size, fewest_spacings) - 1e-6) * size;
}

/// What the stream itself asks for, whatever wave it carries.
ZoneReach reach_of_stream(const Scene& scene, double gravity) {
    const auto width = [&](const Running& water, double of_wave) {
        return in_whole_sizes(scene, of_wave * std::min(wave_of(water, gravity), longest_wave(scene)));
    };
    const Running ahead = ahead_of(scene), behind = behind_of(scene);
    return {has_zone(ahead, scene, gravity) ? width(ahead, ahead_of_wave) : 0,
            has_zone(behind, scene, gravity) ? width(behind, behind_of_wave) : 0,
            has_open_sides(scene) ? width(ahead, side_of_wave) : 0};
}

/// Of a wave in a tank or in a stream: the end that makes it, and how strong its zone is over one that absorbs it
/// (docs/decisions/088-waves.md).
constexpr double lengths_that_make = 1.5, lengths_that_absorb = 1, strength_in_tank = 2, strength_in_stream = 1.5;
/// The same of a following wave that the stream carries back.
constexpr double lengths_that_make_overtaken = 2, lengths_that_absorb_overtaken = 1.5;

/// gamma of a zone of one wave length that absorbs the longest wave that counts [1/s].
double strength_that_absorbs(const Scene& scene, const WaveScales& wave) {
    const double depth = scene.wave ? scene.wave->depth : scene.sea->depth();
    return 1.5 * wave.lowest_frequency / std::sqrt(std::tanh(2 * pi / wave.longest * depth));
}

/// Those of a stream with a wave, on top of what the stream asks for: the end from which its energy comes makes it. One
/// that is wider than the stream's own waves ask for takes them with less strength; with theirs it would be a wall to the
/// wave.
void take_wave(const Scene& scene, ForcingZones& plan) {
    const WaveScales wave = wave_scales(scene);
    const double gamma = strength_that_absorbs(scene, wave);
    const ZoneReach of_stream = reach_of_stream(scene, scene.water.gravity);
    plan.wave_length = wave.longest;
    plan.frequency = wave.lowest_frequency;
    std::string widths;
    for (ForcingZone& zone : plan.zones) {
        if (zone.axis != 0) continue;
        const double width = std::abs(zone.end - zone.begin), lengths = width / wave.longest,
                     own = zone.gamma * std::min(1.0, (zone.high ? of_stream.behind : of_stream.ahead) / width);
        zone.makes_wave = zone.high != wave.comes_from_low_x;
        zone.gamma = zone.makes_wave ? strength_in_stream * gamma
                                     : std::max(own, gamma * std::min(1.0, lengths_that_absorb / lengths));
        widths += fmt::format("{} {} {:.3g} of its lengths", zone.high ? ", the second" : "the first",
                              zone.makes_wave ? "makes the wave over" : "absorbs it over", lengths);
    }
    plan.why = widths + "; " + plan.why;
}

ForcingZones zones_of_stream(const Scene& scene) {
    ForcingZones plan;
    const double U = scene.motion.speed, g = scene.water.gravity;
    plan.wave_length = wave_of(ahead_of(scene), g);
    // shorter waves than this the sizes do not carry; a zone as strong as for them would be a wall to longer ones
    const auto gamma = [&](double speed) { return std::min(g / speed, std::sqrt(2 * pi * g / shortest_wave(scene))); };
    plan.frequency = gamma(U);
    plan.speed = U;
    plan.why = tailwater(scene) ? why_of_two_depths(scene) : why_in_stream(scene, plan.wave_length);
    const Running behind = behind_of(scene);
    const Domain& d = scene.domain;
    for (int axis = 0; axis < 2; ++axis)
        for (const bool high : {false, true}) {
            const double begin = (high ? d.undamped.max : d.undamped.min)[axis],
                         end = (high ? d.box.max : d.box.min)[axis];
            if (begin == end) continue;
            const bool leaves = axis == 0 && high;
            plan.zones.push_back({.axis = axis,
                                  .high = high,
                                  .begin = begin,
                                  .end = end,
                                  .gamma = leaves ? gamma(behind.speed) : plan.frequency,
                                  .share = leaves ? behind.share : 1});
        }
    if (runs_obliquely(scene))
        take_oblique_wave(scene, plan);
    else if (scene.has_wave())
        take_wave(scene, plan);
    return plan;
}

/// Of the bodies that oscillate as prescribed the longest period [s]; 0: none does.
double longest_period(const Scene& scene) {
    double longest = 0;
    for (const MovingBody& b : scene.bodies)
        if (b.motion.law && b.motion.law->kind == MotionLaw::Kind::sinusoid)
            longest = std::max(longest, b.motion.law->period);
    return longest;
}

/// From a wall of the tank to the nearest prescribed body [m].
double clear_of_bodies(const Scene& scene, int axis, bool high) {
    double clear = INFINITY;
    for (const MovingBody& b : scene.bodies) {
        if (!b.motion.law) continue;
        const Box at = b.surface.bounds();
        const double swing = b.motion.law->turns ? 0 : std::abs(b.motion.law->axis[axis]) * b.motion.law->amplitude;
        clear = std::min(clear, high ? scene.domain.box.max[axis] - at.max[axis] - swing
                                     : at.min[axis] - swing - scene.domain.box.min[axis]);
    }
    return std::max(0.0, clear);
}

ForcingZones zones_of_wave(const Scene& scene) {
    const WaveScales wave = wave_scales(scene);
    ForcingZones plan;
    plan.wave_length = wave.longest;
    plan.frequency = wave.lowest_frequency;
    plan.why = fmt::format("the first makes the wave over {:g} of its lengths, the second absorbs it over one",
                           lengths_that_make);
    if (scene.sea)
        plan.why = fmt::format(
            "the first makes the waves over {:g} lengths, the second absorbs them over one length of {:.4g} m; {:.2g} "
            "% "
            "of the energy is in longer waves",
            lengths_that_make, wave.longest, 100 * waves_that_count);
    const double gamma = strength_that_absorbs(scene, wave);
    const Box& box = scene.domain.box;
    const bool from_high = wave.direction < 0;
    for (const bool makes : {true, false}) {
        const bool high = makes == from_high;
        const double end = (high ? box.max : box.min).x(),
                     width = (makes ? lengths_that_make : lengths_that_absorb) * wave.longest;
        plan.zones.push_back({.axis = 0,
                              .high = high,
                              .begin = high ? end - width : end + width,
                              .end = end,
                              .gamma = makes ? strength_in_tank * gamma : gamma,
                              .makes_wave = makes});
    }
    return plan;
}

ForcingZones zones_of_tank(const Scene& scene) {
    ForcingZones plan;
    const Domain& d = scene.domain;
    const double g = scene.water.gravity, h = water_height(scene), period = longest_period(scene);
    if (scene.zones.wave_length > 0) {
        plan.wave_length = scene.zones.wave_length;
        plan.why = fmt::format("waves of {:.3g} m, as [tank] wave_length says", plan.wave_length);
    } else if (period > 0) {
        plan.wave_length = 2 * pi / wave_number(2 * pi / period, g, h);
        plan.why = fmt::format("waves of {:.3g} s, as a body oscillates, are {:.3g} m long in water {:.3g} m deep",
                               period, plan.wave_length, h);
    } else {
        plan.wave_length = d.box.size().x() / 8;
        plan.why =
            fmt::format("no body oscillates, so for waves of an eighth of the tank, {:.3g} m ([tank] wave_length)",
                        plan.wave_length);
    }
    const double k = 2 * pi / plan.wave_length, depth_term = std::tanh(k * h);
    plan.frequency = wave_frequency(k, g, h);
    for (int axis = 0; axis < 2; ++axis)
        for (const bool high : {false, true}) {
            const Side side = axis == 0 ? (high ? d.x_max : d.x_min) : (high ? d.y_max : d.y_min);
            const std::string wall = fmt::format("{}_{}", "xy"[axis], high ? "max" : "min");
            const std::string& named = scene.zones.absorbing;
            if (side == Side::symmetry || (named != "all" && named != wall && named != wall.substr(0, 1))) continue;
            const double room = std::min(d.box.size()[axis] / 2, clear_of_bodies(scene, axis, high)),
                         width = std::min(plan.wave_length, room), of_wave = width / plan.wave_length;
            if (!(width > 0)) continue;
            if (width < plan.wave_length) plan.why += fmt::format("; {} has room for {:.3g} m of them", wall, width);
            const double end = (high ? d.box.max : d.box.min)[axis];
            plan.zones.push_back({axis, high, high ? end - width : end + width, end,
                                  1.5 * plan.frequency / std::sqrt(depth_term) * std::max(1.0, 0.6 / of_wave)});
        }
    return plan;
}

}  // namespace

std::optional<double> standing_wave_length(double speed, double gravity, double depth) {
    const double F2 = speed * speed / (gravity * depth);
    if (!(F2 < 1) || !(speed > 0)) return {};
    // F^2 = tanh(x) / x, x = k h: decreasing in x
    double low = 0, high = 1 / F2;
    for (int step = 0; step < 200 && high - low > 1e-14 * high; ++step) {
        const double x = std::midpoint(low, high);
        (std::tanh(x) > F2 * x ? low : high) = x;
    }
    return 2 * pi * depth / high;
}

bool has_zones_by_default(const Scene& scene, double gravity) {
    return scene.motion.kind == Motion::Kind::stream && gravity > 0 &&
           (waves_stand(scene, gravity) || (scene.has_wave() && !may_enter_with_stream(scene)));
}

ZoneReach zone_reach(const Scene& scene, double gravity) {
    ZoneReach reach;
    if (!scene.has_wave() || waves_stand(scene, gravity)) reach = reach_of_stream(scene, gravity);
    if (runs_obliquely(scene)) {
        const double width = in_whole_sizes(scene, lengths_of_oblique_zones * scene.wave->length);
        for (double* side : {&reach.ahead, &reach.behind, &reach.side}) *side = std::max(*side, width);
    } else if (scene.has_wave()) {
        const WaveScales wave = wave_scales(scene);
        double &makes = wave.comes_from_low_x ? reach.ahead : reach.behind,
               &absorbs = wave.comes_from_low_x ? reach.behind : reach.ahead;
        const bool overtaken = wave.direction < 0 && wave.comes_from_low_x;
        const auto widen = [&](double& width, double lengths) {
            width = std::max(width, in_whole_sizes(scene, lengths * wave.longest));
        };
        widen(makes, overtaken ? lengths_that_make_overtaken : lengths_that_make);
        widen(absorbs, overtaken ? lengths_that_absorb_overtaken : lengths_that_absorb);
    }
    return reach;
}

ForcingZones forcing_zones(const Scene& scene) {
    if (!scene.effect_on("forcing_zones")) return {};
    if (scene.motion.kind == Motion::Kind::stream) return zones_of_stream(scene);
    return scene.has_wave() ? zones_of_wave(scene) : zones_of_tank(scene);
}

}  // namespace tw
