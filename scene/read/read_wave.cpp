#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/errors.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/oblique_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/defaults.h"
#include "scene/read/read.h"
#include "scene/refined_places.h"
#include "scene/water/water_blocks.h"
#include "scene/wave_twin.h"
#include "waves/dispersion.h"
#include "waves/steepness.h"

namespace tw {
namespace {

constexpr double shortest_tank = 3.5;  ///< in wave lengths: 1.5 that make it, one that absorbs it, and one between
constexpr double largest_share = 0.9;  ///< of the highest wave
constexpr double longest_depths = 60;  ///< of a wave length
constexpr double fewest_sizes = 4;     ///< particles or cells in a wave's height
/// The same of a wave that enters with the stream: it is there at once, and has little way to lose height on. Measured
/// with 0.4 particles: 1 to 2 % lost up to a hull (docs/results/wave_in_stream.md).
constexpr double fewest_sizes_at_inlet = 0.5;
constexpr double fewest_along = 20;    ///< in its length
/// Of a stream over the speed of a following wave that it carries back, from which on no other wave comes with it.
constexpr double slowest_overtaking = 1.15;
constexpr double highest_of_thousand = 3.72;  ///< of peaks, over the standard deviation (Longuet-Higgins 1952)
/// Of a stream over that of the wave: its inlet holds level and speed, and above this the zone that makes the wave no
/// longer makes up for that (docs/decisions/088-waves.md).
constexpr double fastest_stream_with_wave = 1.5;

bool in_stream(const Scene& scene) { return scene.motion.kind == Motion::Kind::stream; }

/// Cosine and sine of the wave's direction, exact along the axes.
struct AskedWay {
    double along = 1, across = 0;
};
AskedWay asked_way(const Scene& scene) {
    const double angle = scene.wave_asked.direction;
    const auto exact = [](double x) {
        return std::abs(x) < 1e-6 ? 0.0 : std::abs(x) > 1 - 1e-12 ? std::copysign(1, x) : x;
    };
    return {exact(std::cos(angle)), exact(std::sin(angle))};
}
bool is_oblique(const AskedWay& way) { return way.across != 0; }

/// What this version does not make waves in, of streams.
void refuse_streams(const Scene& scene, Sections& s) {
    if (!scene.bodies.empty())
        s.bodies[0].fail("name",
                         "bodies in a stream with waves are not made yet; expected a hull, held or free in heave and "
                         "pitch, obstacles, or a tank");
    if (s.domain.has("downstream"))
        s.domain.fail("downstream", "a wave runs in water of one depth; remove this key, or [wave]");
    if (s.domain.has("sides") && scene.zones.sides == "open" && !is_oblique(asked_way(scene)))
        s.domain.fail("sides",
                      "with [wave] the sides are walls, because zones there would take the wave away beside "
                      "the hull; remove this key, or write \"walls\"");
}

/// What this version does not make waves in.
void refuse_surroundings(const Scene& scene, Sections& s) {
    const SceneSection& wave = s.wave;
    if (is_oblique(asked_way(scene)))
        refuse_oblique_surroundings(scene, s, scene.wave_asked.direction * 180 / std::numbers::pi);
    if (in_stream(scene))
        refuse_streams(scene, s);
    else if (!s.tank.present())
        wave.fail("height",
                  "a wave is made in a tank between walls or in a stream; expected [tank] with min and max, z "
                  "from -depth, or [motion] kind = \"stream\" with its speed");
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

/// Keys that the other kinds of waves have: a value that is not used misleads.
void refuse_foreign_keys(const Scene& scene, const SceneSection& wave) {
    const std::string& kind = scene.wave_asked.spectrum;
    const bool focused = kind == "focused", random = kind == "jonswap" || kind == "pierson-moskowitz",
               two = kind == "bichromatic", regular = kind == "regular";
    const std::pair<const char*, bool> used[] = {{"height", regular || two},
                                                 {"length", regular},
                                                 {"period", regular || two},
                                                 {"theory", regular},
                                                 {"significant_height", random},
                                                 {"peak_period", random || focused},
                                                 {"peakedness", kind == "jonswap" || focused},
                                                 {"components", random || focused},
                                                 {"seed", random},
                                                 {"second_height", two},
                                                 {"second_period", two},
                                                 {"crest", focused},
                                                 {"focus_place", focused},
                                                 {"focus_time", focused}};
    for (const auto& [key, of_this] : used)
        if (!of_this && wave.has(key))
            wave.fail(key,
                      fmt::format("is not used with spectrum = \"{}\"; remove it, or write another spectrum", kind));
}

/// The tank holds the zones and what lies between them, and the highest crest.
void check_tank(const Scene& scene, Sections& s, const std::string& size) {
    const WaveScales wave = wave_scales(scene);
    const double tank = scene.domain.box.size().x(), least = 2.5 * wave.longest + wave.length;
    if (tank < least * (1 - 1e-9))
        s.wave.fail(size, scene.wave
                              ? fmt::format("the wave is {:.4g} m long and the tank {:.4g} m; expected a tank of at "
                                            "least {:.4g} m, {:g} wave lengths: 1.5 for the zone that makes it, one "
                                            "for the zone that absorbs it, one between",
                                            wave.length, tank, least, shortest_tank)
                              : fmt::format("the tank is {:.4g} m long; expected at least {:.4g} m: 1.5 and one "
                                            "lengths of {:.4g} m for the zones that make and absorb the waves (the "
                                            "longest that count: {:g} % of the energy is in longer ones), and one "
                                            "length of {:.4g} m at the peak between",
                                            tank, least, wave.longest, 100 * waves_that_count, wave.length));
    if (wave.crest > scene.domain.box.max.z())
        s.tank.fail(
            s.tank.has("max") ? "max" : "size",
            fmt::format("the tank ends {:.4g} m above still water, and the wave's crest is at {:.4g} m; expected "
                        "a higher tank",
                        scene.domain.box.max.z(), wave.crest));
}

/// The highest crest lies in a stream's box.
void check_height_of_box(const Scene& scene, Sections& s, double crest) {
    if (crest > scene.domain.as_asked.max.z())
        s.domain.fail(s.domain.has("above") ? "above" : "z",
                      fmt::format("the box ends {:.4g} m above still water, and the wave's crest is at {:.4g} m; "
                                  "expected a higher box",
                                  scene.domain.as_asked.max.z(), crest));
}

/// Everywhere water comes in at the inlet and leaves at the outlet: the stream is faster than the waves move it back.
void check_ends(const Scene& scene, Sections& s, const char* height, double back) {
    const double U = scene.motion.speed;
    if (U >= back) return;
    const WaveScales wave = wave_scales(scene);
    s.wave.fail(height,
                fmt::format("under its {} the water moves at {:.4g} m/s against the stream of {:.4g} m/s, and would "
                            "{}; expected a stream of at least {:.4g} m/s, or lower waves",
                            wave.direction < 0 ? "crests" : "troughs", back, U,
                            wave.comes_from_low_x ? "leave through the inlet" : "come in through the outlet", back));
}

/// Of a stream that is too fast for zones: without them head waves enter with it.
std::string how_to_let_in(const Scene& scene) {
    const char* off = "forcing_zones = \"off\" in [effects]";
    if (may_enter_with_stream(scene))
        return fmt::format("; or {}: then the wave{} with the stream", off, scene.sea ? "s enter" : " enters");
    if (!scene.sea || scene.sea->waves.direction < 0) return {};
    return fmt::format(
        "; or a stream of at least {:.4g} m/s and {}: the speed of the longest waves that count ({:g} % "
        "of the energy is in longer ones), which then enter with it",
        fastest_that_counts(scene), off, 100 * waves_that_count);
}

void check_fastest(const Scene& scene, Sections& s, const std::string& size, double length, double speed) {
    const double U = scene.motion.speed, most = fastest_stream_with_wave * speed;
    if (U <= most * (1 + 1e-9)) return;
    const double slower = U / fastest_stream_with_wave;  // deep water's length of that speed
    s.wave.fail(size, fmt::format("the wave{}, {:.4g} m long, runs at {:.4g} m/s and the stream at {:.4g} m/s; the "
                                  "inlet, which holds level and speed, then spoils its height by a tenth: expected a "
                                  "stream of at most {:.4g} m/s, {:g} times the wave's speed, or a longer wave (in "
                                  "deep water of {:.3g} m){}",
                                  scene.sea ? " (the shortest that counts)" : "", length, speed, U, most,
                                  fastest_stream_with_wave,
                                  2 * std::numbers::pi * slower * slower / scene.water.gravity, how_to_let_in(scene)));
}

/// Before the box is as large as its zones make it, which follow from the wave.
bool enters_with_stream(const Scene& scene, Sections& s) {
    return may_enter_with_stream(scene) &&
           !s.effects.on_off("forcing_zones").value_or(has_zones_by_default(scene, scene.water.gravity));
}

/// A following wave comes from behind or is overtaken. Between, its energy hardly passes the hull, or, where that has
/// passed, waves of other lengths have its frequency of encounter and come with it.
void check_following(const Scene& scene, Sections& s, const std::string& size) {
    const RegularWave& wave = *scene.wave;
    const double U = scene.motion.speed, group = wave.group_speed_in_water(), behind = slowest_passing * group,
                 ahead = slowest_overtaking * wave.speed_in_water;
    if (U > behind && U < ahead)
        s.wave.fail(size,
                    fmt::format("this following wave, {:.4g} m long, runs at {:.4g} m/s, its energy at {:.4g} m/s, "
                                "and the stream at {:.4g} m/s against them, so that it nearly stands still or "
                                "comes with others of its frequency; expected a stream of at most {:.4g} m/s (the "
                                "wave comes from behind) or of {:.4g} to {:.4g} m/s (the hull overtakes it), or a "
                                "wave of another length",
                                wave.length, wave.speed_in_water, group, U, behind, ahead,
                                fastest_stream_with_wave * wave.speed_in_water));
}

/// Of a sum that follows what stands still or is carried back by the stream is not made; it may be little.
void check_following_sea(const Scene& scene, Sections& s, const std::string& size, SeaOrder order) {
    const double U = scene.motion.speed;
    order.stream = 0;
    const Sea whole = make_sea(order);
    const int high = whole.component_at(1 - waves_that_count);
    const double k = whole.waves.k[high], energy = group_speed_ratio(k * order.depth) * whole.waves.omega[high] / k;
    if (U > slowest_passing * energy)
        s.wave.fail(
            size, fmt::format("the energy of the shortest of these following waves that count, {:.4g} m long, runs at "
                              "{:.4g} m/s and the stream at {:.4g} m/s against it, so that it hardly passes the hull "
                              "or never comes; expected a stream of at most {:.4g} m/s, or longer waves",
                              2 * std::numbers::pi / k, energy, U, slowest_passing * energy));
}

/// The stream is slow enough for the zone that makes the wave and fast enough for its inlet, and the box holds its
/// crest.
void check_stream(const Scene& scene, Sections& s, const std::string& size) {
    const RegularWave& wave = *scene.wave;
    const double U = scene.motion.speed;
    if (!enters_with_stream(scene, s)) check_fastest(scene, s, size, wave.length, wave.speed_in_water);
    const bool follows = wave.sum.direction < 0;
    double u, v, w;  // where it is slowest along x: under a trough, of a following wave under a crest
    const double half = follows ? 0 : std::numbers::pi / wave.k();
    wave_velocity(wave.sum, wave.sum.direction * half, wave.sum.across * half, follows ? wave.crest : wave.trough, 0, u,
                  v, w);
    check_ends(scene, s, "height", U - u);
    if (runs_obliquely(scene))
        check_oblique_wave(scene, s, size);
    else if (follows)
        check_following(scene, s, size);
    check_height_of_box(scene, s, wave.crest);
}

/// The same of a sum of waves: for the shortest that count, and where the highest of a thousand, or all, come together.
void check_stream_of_sea(const Scene& scene, Sections& s, const std::string& size) {
    const Sea& sea = *scene.sea;
    const WaveComponents& waves = sea.waves;
    const int high = sea.component_at(1 - waves_that_count);
    if (!enters_with_stream(scene, s))
        check_fastest(scene, s, size, sea.length(high), waves.omega[high] / waves.k[high]);
    double all = 0, squares = 0;
    for (int n = 0; n < waves.count; ++n) {
        const double along = waves.height[n] * waves.omega[n] / std::tanh(waves.k[n] * waves.depth);
        all += along, squares += along * along / 2;
    }
    const bool random = sea.kind == Sea::Kind::jonswap || sea.kind == Sea::Kind::pierson_moskowitz;
    check_ends(scene, s,
               random                           ? "significant_height"
               : sea.kind == Sea::Kind::focused ? "crest"
                                                : "height",
               random ? highest_of_thousand * std::sqrt(squares) : all);
    check_height_of_box(scene, s, wave_scales(scene).crest);
}

double required(const SceneSection& wave, const char* key, double value, const char* what, const char* example) {
    if (!wave.has(key)) wave.fail(key, fmt::format("missing; {}, e.g. {} = \"{}\"", what, key, example));
    return value;
}

/// A sum of waves whose highest ones would break is none.
void refuse_breaking(const SceneSection& wave, const char* key, double height, double length, double depth,
                     double share, const char* what) {
    const double most = share * highest_wave(length, depth);
    if (height > most)
        wave.fail(key, fmt::format("{:.4g} m; {} of {:.4g} m in water {:.4g} m deep would break: expected at most "
                                   "{:.4g} m, {:g} % of the highest wave there, or longer waves",
                                   height, what, length, depth, most, 100 * share));
}

double length_of(const SeaOrder& order, double period) {
    return 2 * std::numbers::pi / wave_number(2 * std::numbers::pi / period, order.gravity, order.depth);
}

void order_two(SeaOrder& order, const WaveOptions& asked, const SceneSection& wave) {
    order.kind = Sea::Kind::bichromatic;
    order.heights[0] = required(wave, "height", asked.height, "the first of two waves needs its height", "40 mm");
    order.periods[0] = required(wave, "period", asked.period, "the first of two waves needs its period", "1.2 s");
    order.heights[1] =
        required(wave, "second_height", asked.second_height, "the second wave needs its height", "40 mm");
    order.periods[1] = required(wave, "second_period", asked.second_period, "the second wave needs its period", "1 s");
    if (std::abs(std::log(order.periods[0] / order.periods[1])) < 0.02)
        wave.fail("second_period",
                  fmt::format("{:.4g} s; the first wave has {:.4g} s: expected periods that differ by 2 % and more, "
                              "else a beat is longer than 50 waves",
                              order.periods[1], order.periods[0]));
    refuse_breaking(wave, "second_height", order.heights[0] + order.heights[1],
                    std::min(length_of(order, order.periods[0]), length_of(order, order.periods[1])), order.depth,
                    largest_share,
                    "where both have their crests a wave as high as both together and as long as the shorter one,");
}

void order_spectrum(SeaOrder& order, const WaveOptions& asked, const SceneSection& wave) {
    order.peak_period =
        required(wave, "peak_period", asked.peak_period, "a spectrum needs the period of its peak", "1.2 s");
    order.peakedness = asked.peakedness;
    order.components = asked.components;
    order.seed = static_cast<std::uint64_t>(asked.seed);
    const double length = length_of(order, order.peak_period);
    if (asked.spectrum == "focused") {
        order.kind = Sea::Kind::focused;
        order.height = required(wave, "crest", asked.crest, "a focused wave needs its crest by linear theory", "50 mm");
        refuse_breaking(wave, "crest", order.height, length, order.depth, 0.5, "a group at a peak");
    } else {
        order.kind = asked.spectrum == "jonswap" ? Sea::Kind::jonswap : Sea::Kind::pierson_moskowitz;
        order.height = required(wave, "significant_height", asked.significant_height,
                                "a spectrum needs its significant height", "50 mm");
        refuse_breaking(wave, "significant_height", order.height, length, order.depth, 0.5,
                        "the highest of such waves, about 1.8 times as high, at a peak");
    }
}

/// Where and when, unless it is given: both follow from the zones, which follow from the spectrum in `scene.sea`, or from
/// the inlet.
void place_focus(SeaOrder& order, Scene& scene, const SceneSection& wave, bool enters) {
    WaveOptions& asked = scene.wave_asked;
    const WaveScales scales = wave_scales(scene);
    const Box& box = scene.domain.as_asked;  // the same at every resolution
    const double making = 1.5 * scales.longest, absorbing = scales.longest;
    const bool stream = in_stream(scene);  // its zones lie outside the box
    const double low = box.min.x() + (stream                ? 0
                                      : order.direction > 0 ? making
                                                            : absorbing),
                 high = box.max.x() - (stream                ? 0
                                       : order.direction > 0 ? absorbing
                                                             : making);
    if (!wave.has("focus_place")) asked.focus_place = (low + high) / 2;
    if (asked.focus_place < low || asked.focus_place > high)
        wave.fail("focus_place",
                  fmt::format("x = {:.4g} m lies in a zone or outside the water; expected a place between "
                              "the zones, from {:.4g} to {:.4g} m",
                              asked.focus_place, low, high));
    const double from_zone = std::abs(asked.focus_place - (order.direction > 0 ? low : high)),
                 way = enters                            ? from_zone
                       : stream || begins_in_zone(scene) ? making + from_zone  // the zone grows them over its width
                                                         : 0,
                 least = way / scales.slowest + (stream ? default_ramp(scene) : 0) +
                         (enters ? time_to_grow_at_inlet(scene) : 0);
    if (!wave.has("focus_time")) asked.focus_time = 4 * scales.period + least;
    if (asked.focus_time < least)
        wave.fail(
            "focus_time",
            enters
                ? fmt::format("{:.4g} s; the waves have grown at the inlet, and come from there to the focus, after "
                              "{:.4g} s: expected at least that",
                              asked.focus_time, least)
                : fmt::format("{:.4g} s; the shortest waves that count take {:.4g} s through the zone that makes them "
                              "and to the focus, and {} they begin in that zone: expected at least that",
                              asked.focus_time, least, stream ? "in a stream" : "with solids in the tank"));
    const double latest = scene.sea->repeat_period - 2 * scales.period;
    if (asked.focus_time > latest)
        wave.fail(
            "focus_time",
            fmt::format("{:.4g} s; a sum of {} waves repeats itself after {:.4g} s, so that an earlier group would "
                        "come first: expected at most {:.4g} s, or more components",
                        asked.focus_time, asked.components, scene.sea->repeat_period, latest));
    order.focus_place = asked.focus_place;
    order.focus_time = asked.focus_time;
}

void settle_sea(Scene& scene, Sections& s) {
    const SceneSection& wave = s.wave;
    SeaOrder order{.depth = -scene.domain.as_asked.min.z(), .gravity = scene.water.gravity};
    order.direction = asked_way(scene).along;
    if (in_stream(scene)) order.stream = scene.motion.speed;
    const bool two = scene.wave_asked.spectrum == "bichromatic";
    (two ? order_two : order_spectrum)(order, scene.wave_asked, wave);
    const std::string size = two ? "period" : "peak_period";
    const double longest = length_of(order, two ? std::max(order.periods[0], order.periods[1]) : order.peak_period);
    if (longest > longest_depths / 2 * order.depth)
        wave.fail(size,
                  fmt::format("waves {:.4g} m long in water {:.4g} m deep; expected at most {:g} depths: longer ones "
                              "are no sum of linear waves",
                              longest, order.depth, longest_depths / 2));
    if (in_stream(scene) && order.direction < 0) check_following_sea(scene, s, size, order);
    scene.sea = make_sea(order);
    in_stream(scene) ? check_stream_of_sea(scene, s, size) : check_tank(scene, s, size);
    if (order.kind != Sea::Kind::focused) return;
    place_focus(order, scene, wave, enters_with_stream(scene, s));
    scene.sea = make_sea(order);
}

}  // namespace

void settle_wave(Scene& scene, Sections& s) {
    if (!s.wave.present()) return;
    const SceneSection& wave = s.wave;
    const WaveOptions& asked = scene.wave_asked;
    refuse_foreign_keys(scene, wave);
    if (asked.spectrum != "regular") {
        refuse_surroundings(scene, s);
        return settle_sea(scene, s);
    }
    if (!wave.has("height")) wave.fail("height", "missing; a wave needs its height, e.g. height = \"0.04 m\"");
    if (wave.has("length") == wave.has("period"))
        wave.fail(wave.has("length") ? "period" : "length",
                  wave.has("length") ? "given beside length; a wave has one of the two, remove the other"
                                     : "missing; a wave needs its length or its period, e.g. length = \"1 m\"");
    refuse_surroundings(scene, s);
    const std::string size = wave.has("length") ? "length" : "period";
    WaveOrder order{.height = asked.height, .depth = -scene.domain.as_asked.min.z(), .gravity = scene.water.gravity};
    order.direction = asked_way(scene).along;
    order.across = asked_way(scene).across;
    order.closed = !in_stream(scene);
    order.stream = scene.motion.speed;
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
    in_stream(scene) ? check_stream(scene, s, size) : check_tank(scene, s, size);
}

void check_wave(const Scene& scene, Sections& s) {
    if (!scene.has_wave()) return;
    if (scene.wave_asked.empty_twin == "on" && (!scene.wave || !has_empty_twin(scene)))
        s.wave.fail("empty_twin",
                    scene.wave
                        ? "no free rigid body and no obstacle is in the tank whose response or load could be over "
                          "the wave there; expected [[body]] or [[obstacle]], or remove this key"
                        : "responses are given in regular waves; remove this key");
    if (scene.wave_asked.calm_twin == "on" && (!scene.wave || !scene.hull || !in_stream(scene)))
        s.wave.fail("calm_twin",
                    "what a wave adds is given of a hull in a stream with a regular wave; remove this key");
    const WaveScales wave = wave_scales(scene);
    const bool enters = inlet_wave(scene).has_value();
    if (!scene.effect_on("forcing_zones") && !enters)
        s.effects.fail(
            "forcing_zones",
            fmt::format("the wave is made and absorbed by them; remove this key, or [wave]{}",
                        scene.motion.kind == Motion::Kind::stream && wave.direction > 0
                            ? fmt::format(" (without them head waves enter with a stream of at least {}, "
                                          "{:.4g} m/s in the water)",
                                          scene.wave ? "their own speed"
                                                     : fmt::format("the speed of the longest that count, "
                                                                   "with {:g} % of the energy in longer ones",
                                                                   100 * waves_that_count),
                                          fastest_that_counts(scene))
                            : ""));
    for (const char* effect : {"air", "dynamic_pressure"})
        if (scene.effect_on(effect))
            s.effects.fail(effect, "particles begin with it in water at rest only; switch it off, or remove [wave]");
    if (scene.sph.levels > 1 && !enters)
        throw InputError(scene.place_of("sph.levels") +
                         ": particles of several sizes carry no wave yet; write levels = 1 in [sph]");
    if (has_coarse_zones(scene))
        throw InputError(scene.place_of("sph.zones") +
                         ": a wave is not made by coarse particles; write zones = \"fine\" in [sph]");
    const double size = scene.resolution.near_hull;
    const auto given = [&](std::initializer_list<const char*> keys) {
        for (const char* key : keys)
            if (s.wave.has(key)) return key;
        return *keys.begin();
    };
    const char *of_height = given({"height", "significant_height", "crest"}),
               *of_length = given({"length", "period", "peak_period"});
    const double fewest = enters ? fewest_sizes_at_inlet : fewest_sizes;
    const char* kept_well = enters ? "" : " (six to ten keep it well)";
    if (wave.height < fewest * size * (1 - 1e-9))
        s.wave.fail(of_height,
                    fmt::format("{:.4g} m are {:.2g} times near_hull = {:.4g} m; expected at least {:g} in a "
                                "wave's height{}: near_hull at most {:.3g} m",
                                wave.height, wave.height / size, size, fewest, kept_well, wave.height / fewest));
    // of a sum half as many in the shortest that count
    const double coarsest = scene.resolution.spacing, along = scene.wave ? fewest_along : fewest_along / 2;
    if (wave.shortest < along * coarsest * (1 - 1e-9))
        s.wave.fail(
            of_length,
            fmt::format("the {} of {:.4g} m is {:.2g} times the largest size, {:.4g} m; expected at least {:g}: "
                        "[resolution] spacing at most {:.3g} m",
                        scene.wave ? "wave" : "shortest wave that counts", wave.shortest, wave.shortest / coarsest,
                        coarsest, along, wave.shortest / along));
    std::vector<std::pair<std::string, Box>> solids;
    if (scene.hull) solids.emplace_back("the hull", scene.hull->surface.bounds());
    for (const MovingBody& b : scene.bodies) solids.emplace_back("body " + b.name, b.surface.bounds());
    for (const Obstacle& o : scene.obstacles) solids.emplace_back("obstacle " + o.name, o.surface.bounds());
    for (const ForcingZone& zone : forcing_zones(scene).zones)
        for (const auto& [name, at] : solids) {
            if (zone.high ? at.max[zone.axis] > zone.begin : at.min[zone.axis] < zone.begin)
                s.wave.fail(
                    of_length,
                    fmt::format("{} stands in the zone that ends at {} = {:.4g} m, which makes or absorbs the wave; "
                                "expected a {} {}, or the solid nearer to its middle",
                                name, "xy"[zone.axis], zone.begin, zone.axis == 0 ? "longer" : "wider",
                                in_stream(scene) ? "box" : "tank"));
        }
}

}  // namespace tw
