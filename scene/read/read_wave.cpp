#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scene/box/forcing_zones.h"
#include "scene/read/read.h"
#include "scene/water/water_blocks.h"
#include "waves/dispersion.h"
#include "waves/steepness.h"

namespace tw {
namespace {

constexpr double shortest_tank = 3.5;  ///< in wave lengths: 1.5 that make it, one that absorbs it, and one between
constexpr double largest_share = 0.9;  ///< of the highest wave
constexpr double longest_depths = 60;  ///< of a wave length
constexpr double fewest_sizes = 4;     ///< particles or cells in a wave's height
constexpr double fewest_along = 20;    ///< in its length

/// What this version does not make waves in.
void refuse_surroundings(const Scene& scene, Sections& s) {
    const SceneSection& wave = s.wave;
    if (scene.motion.kind == Motion::Kind::stream)
        wave.fail("height",
                  "a wave in a stream is not made yet; expected a tank: [tank] with min and max, and no speed");
    if (!s.tank.present())
        wave.fail("height", "a wave is made in a tank between walls; expected [tank] with min and max, z from -depth");
    if (scene.tank_motion) s.tank.fail("law", "a tank that moves makes waves of its own; remove [wave], or the motion");
    if (!scene.water_blocks.empty())
        s.water_blocks[0].fail("min",
                               "with [wave] all of the tank below z = 0 is water; remove the blocks, and put the "
                               "floor at z = -depth by [tank] min");
    if (s.tank.has("absorbing"))
        s.tank.fail("absorbing",
                    "with [wave] the zones are at the ends that it comes from and runs to; remove this key");
    if (s.tank.has("wave_length"))
        s.tank.fail("wave_length", "with [wave] the zones are as wide as its length; remove this key");
    if (!(scene.water.gravity > 0) || !s.effects.on_off("gravity").value_or(true))
        wave.fail("height", "without gravity there are no waves; expected gravity on");
}

double direction_of(const Scene& scene, const SceneSection& wave) {
    const double angle = scene.wave_asked.direction, along = std::cos(angle);
    if (std::abs(std::sin(angle)) > 1e-6)
        wave.fail("direction", fmt::format("{:.4g} degrees: oblique waves are not made yet; expected 0 (towards +x) or "
                                           "\"180 deg\" (towards -x)",
                                           angle * 180 / std::numbers::pi));
    return along > 0 ? 1 : -1;
}

}  // namespace

void settle_wave(Scene& scene, Sections& s) {
    if (!s.wave.present()) return;
    const SceneSection& wave = s.wave;
    const WaveOptions& asked = scene.wave_asked;
    if (!wave.has("height")) wave.fail("height", "missing; a wave needs its height, e.g. height = \"0.04 m\"");
    if (wave.has("length") == wave.has("period"))
        wave.fail(wave.has("length") ? "period" : "length",
                  wave.has("length") ? "given beside length; a wave has one of the two, remove the other"
                                     : "missing; a wave needs its length or its period, e.g. length = \"1 m\"");
    refuse_surroundings(scene, s);
    const std::string size = wave.has("length") ? "length" : "period";
    WaveOrder order{.height = asked.height, .depth = -scene.domain.as_asked.min.z(), .gravity = scene.water.gravity};
    order.direction = direction_of(scene, wave);
    if (asked.length > 0) order.length = asked.length;
    if (asked.period > 0) order.period = asked.period;
    if (asked.theory != "auto")
        order.theory = asked.theory == "linear" ? RegularWave::Theory::linear : RegularWave::Theory::stream_function;

    const double length =
        order.length
            ? *order.length
            : 2 * std::numbers::pi / wave_number(2 * std::numbers::pi / *order.period, order.gravity, order.depth);
    if (length > longest_depths * order.depth)
        wave.fail(size,
                  fmt::format("a wave {:.4g} m long in water {:.4g} m deep; expected at most {:g} depths: a longer "
                              "one is a row of solitary waves",
                              length, order.depth, longest_depths));
    const double highest = highest_wave(length, order.depth);
    if (order.height > largest_share * highest)
        wave.fail("height",
                  fmt::format("the highest wave of {:.4g} m in water {:.4g} m deep is {:.4g} m high, and this "
                              "one would break; expected at most {:.4g} m, {:g} % of it, or a longer wave",
                              length, order.depth, highest, largest_share * highest, 100 * largest_share));
    try {
        scene.wave = regular_wave(order);
    } catch (const std::domain_error& e) {
        wave.fail("height", fmt::format("{} (length about {:.4g} m, depth {:.4g} m); expected a lower wave", e.what(),
                                        length, order.depth));
    }
    const double tank = scene.domain.box.size().x();
    if (tank < shortest_tank * scene.wave->length * (1 - 1e-9))
        wave.fail(size,
                  fmt::format("the wave is {:.4g} m long and the tank {:.4g} m; expected a tank of at least {:.4g} m, "
                              "{:g} wave lengths: 1.5 for the zone that makes it, one for the zone that absorbs it, "
                              "one between",
                              scene.wave->length, tank, shortest_tank * scene.wave->length, shortest_tank));
    if (scene.wave->crest > scene.domain.box.max.z())
        s.tank.fail(
            s.tank.has("max") ? "max" : "size",
            fmt::format("the tank ends {:.4g} m above still water, and the wave's crest is at {:.4g} m; expected a "
                        "higher tank",
                        scene.domain.box.max.z(), scene.wave->crest));
}

void check_wave(const Scene& scene, Sections& s) {
    if (!scene.wave) return;
    const RegularWave& wave = *scene.wave;
    if (!scene.effect_on("forcing_zones"))
        s.effects.fail("forcing_zones", "a wave is made and absorbed by them; remove this key, or [wave]");
    for (const char* effect : {"air", "dynamic_pressure"})
        if (scene.effect_on(effect))
            s.effects.fail(effect, "particles begin with it in water at rest only; switch it off, or remove [wave]");
    if (scene.sph.levels > 1)
        throw InputError(scene.place_of("sph.levels") +
                         ": particles of several sizes do not begin with a wave; write levels = 1 in [sph]");
    const double size = scene.resolution.near_hull;
    if (wave.height < fewest_sizes * size * (1 - 1e-9))
        s.wave.fail(
            "height",
            fmt::format("{:.4g} m are {:.2g} times near_hull = {:.4g} m; expected at least {:g} in a wave's height "
                        "(six to ten keep it well): near_hull at most {:.3g} m",
                        wave.height, wave.height / size, size, fewest_sizes, wave.height / fewest_sizes));
    const double coarsest = scene.resolution.spacing;
    if (wave.length < fewest_along * coarsest * (1 - 1e-9))
        s.wave.fail(
            s.wave.has("length") ? "length" : "period",
            fmt::format("the wave of {:.4g} m is {:.2g} times the largest size, {:.4g} m; expected at least {:g}: "
                        "[resolution] spacing at most {:.3g} m",
                        wave.length, wave.length / coarsest, coarsest, fewest_along, wave.length / fewest_along));
    std::vector<std::pair<std::string, Box>> solids;
    if (scene.hull) solids.emplace_back("the hull", scene.hull->surface.bounds());
    for (const MovingBody& b : scene.bodies) solids.emplace_back("body " + b.name, b.surface.bounds());
    for (const Obstacle& o : scene.obstacles) solids.emplace_back("obstacle " + o.name, o.surface.bounds());
    for (const ForcingZone& zone : forcing_zones(scene).zones)
        for (const auto& [name, at] : solids) {
            if (zone.high ? at.max.x() > zone.begin : at.min.x() < zone.begin)
                s.wave.fail(
                    s.wave.has("length") ? "length" : "period",
                    fmt::format("{} stands in the zone that ends at x = {:.4g} m, which makes or absorbs the wave; "
                                "expected a longer tank, or the solid nearer to its middle",
                                name, zone.begin));
        }
}

}  // namespace tw
