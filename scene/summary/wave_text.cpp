#include "scene/summary/wave_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "methods/names.h"
#include "scene/box/forcing_zones.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/oblique_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/wave_twin.h"
#include "waves/dispersion.h"
#include "waves/steepness.h"

namespace tw {
namespace {

bool particles_run(const Scene& scene) {
    return std::ranges::find(scene.run.methods, sph_method) != scene.run.methods.end();
}

double between_zones(const Scene& scene) {
    double between = scene.domain.box.size().x();
    for (const ForcingZone& zone : forcing_zones(scene).zones)
        if (zone.axis == 0) between -= std::abs(zone.end - zone.begin);
    return between;
}

/// Where it runs, as a direction of the scene says it.
std::string towards(const RegularWave& w) {
    return w.sum.across == 0 ? fmt::format("{}x", w.sum.direction > 0 ? "+" : "-")
                             : fmt::format("{:.4g} degrees from +x to +y",
                                           std::atan2(w.sum.across, w.sum.direction) * 180 / std::numbers::pi);
}

/// From where an oblique wave comes to a hull that runs towards -x: low y is to its port side.
std::string comes_from(const RegularWave& w) {
    const std::string side = w.sum.across > 0 ? "port" : "starboard";
    const double along = w.sum.direction, beam = std::sin(10 * std::numbers::pi / 180);
    if (std::abs(along) < beam) return "a beam wave from " + side;
    return fmt::format("from the {} {}", side, along > 0 ? "bow" : "quarter");
}

/// Of an oblique wave: how it is met, and where its energy comes from.
std::string oblique_text(const Scene& scene) {
    const RegularWave& w = *scene.wave;
    const Eigen::Vector2d energy = energy_velocity(scene);
    return fmt::format(
        "{:.4g} m/s in the water, {}: {:.4g} s in the water, met every {:.4g} s (U omega_e/g {:.3g}); its energy runs "
        "at ({:.4g}, {:.4g}) m/s past the hull, and fills the box from {} and {} in {:.4g} s",
        w.speed_in_water, comes_from(w), w.period_in_water(), w.encounter_period(),
        scene.motion.speed * w.encounter_frequency() / w.gravity, energy.x(), energy.y(),
        energy.x() < 0 ? "behind" : "ahead", energy.y() > 0 ? "low y" : "high y", time_to_fill(scene));
}

/// Of a stream over the speed of a following wave's energy: above it the zone that makes the wave no longer keeps its
/// height within 5 % (docs/decisions/088-waves.md).
constexpr double kept_well_below = 0.55;

/// How fast it runs, and what current it has.
std::string speed_text(const Scene& scene) {
    const RegularWave& w = *scene.wave;
    if (scene.motion.kind != Motion::Kind::stream)
        return fmt::format(
            "{:.4g} m/s over still water; mean current below the troughs {:.3g} m/s, so that the tank has no net "
            "transport",
            w.speed_in_water, w.sum.current);
    if (runs_obliquely(scene)) return oblique_text(scene);
    const bool follows = w.sum.direction < 0;
    const WaveScales scales = wave_scales(scene);
    return fmt::format(
        "{:.4g} m/s in the water, with the stream {:.4g} m/s past the hull: a {} wave of {:.4g} s in the water, met "
        "every {:.4g} s (U omega_e/g {:.3g}); its front runs at {:.4g} m/s{}",
        w.speed_in_water, std::abs(w.sum.speed),
        !follows          ? "head"
        : w.sum.speed > 0 ? "following"
                          : "following (overtaken)",
        w.period_in_water(), w.encounter_period(), scene.motion.speed * std::abs(w.encounter_frequency()) / w.gravity,
        scales.slowest,
        !follows ? ""
        : scales.comes_from_low_x
            ? " from ahead, since the stream is faster than it; by a linear model its height is within "
              "5 to 13 % of that asked for"
        : scene.motion.speed > kept_well_below * (scene.motion.speed + scales.slowest)
            ? " from behind; so near to the speed of its energy, by a linear model its height is within 15 % of that "
              "asked for"
            : " from behind");
}

/// Of a wave or waves that do: how and when; empty of others.
std::string enters_text(const Scene& scene) {
    const auto enters = inlet_wave(scene);
    if (!enters) return {};
    return fmt::format(
        "  enters    with the stream, which is faster than {}, through the inlet; from {:.4g} s on, at {} full height "
        "from {:.4g} s on\n",
        scene.wave ? "it"
                   : fmt::format("the longest that count, {:.4g} m/s in the water ({:g} % of the energy is in longer "
                                 "ones)",
                                 fastest_that_counts(scene), 100 * waves_that_count),
        enters->begin, scene.wave ? "its" : "their", enters->begin + enters->ramp);
}
const char* where_it_runs(const Scene& scene) { return inlet_wave(scene) ? "in the box" : "between the zones"; }

/// The regular wave: what it is by theory, how it is resolved, and what becomes of it on its way.
std::string regular_wave_text(const Scene& scene) {
    const RegularWave& w = *scene.wave;
    const Resolution& r = scene.resolution;
    const bool linear = w.theory == RegularWave::Theory::linear;
    const double between = between_zones(scene);
    const char* where = where_it_runs(scene);
    std::string out = fmt::format(
        "wave        {:.4g} m high, {:.4g} m long, period {:.4g} s, towards {}; crest {:.4g} m, trough {:.4g} m\n"
        "  theory    {}: {}\n"
        "  regime    {}; H/L {:.3g}, k d {:.3g} ({} water), Ursell {:.3g}, {:.2g} % of the highest wave\n"
        "  speed     {}\n",
        w.height, w.length, w.encounter_period(), towards(w), w.crest, w.trough,
        linear ? "linear" : fmt::format("stream function, {} terms", w.sum.terms), w.why,
        wave_regime(w.height, w.length, w.depth), w.height / w.length, w.k() * w.depth, depth_regime(w.length, w.depth),
        ursell_number(w.height, w.length, w.depth), 100 * w.height / highest_wave(w.length, w.depth),
        speed_text(scene));
    out += enters_text(scene) +
           fmt::format(
               "  sizes     {:.3g} of near_hull in its height, {:.4g} in its length; {:.3g} wave lengths {}\n"
               "  run       {:.3g} periods",
               w.height / r.near_hull, w.length / r.near_hull, between / w.length, where,
               scene.run.duration / w.encounter_period());
    if (particles_run(scene))
        out += fmt::format(
            "; artificial viscosity takes {:.2g} % of the particles' height in a wave length, {:.2g} % "
            "{}{}",
            100 * loss_by_artificial_viscosity(scene, w.length), 100 * loss_by_artificial_viscosity(scene, between),
            where, inlet_wave(scene) ? "" : " (measured, of all causes: 2 to 4 % at eight particles in the height)");
    if (wants_wave_twin(scene))
        out += scene.hull ? "\n  twin      each size is run without the wave too: what drag, trim and rise are more in "
                            "waves is given"
                          : "\n  twin      each size is run without the bodies too: responses are given over the wave "
                            "there as well";
    return out + "\n";
}

std::string what_it_is(const Sea& sea) {
    const auto& w = sea.waves;
    switch (sea.kind) {
        case Sea::Kind::bichromatic:
            return fmt::format("two waves, {:.4g} m and {:.4g} s, {:.4g} m and {:.4g} s", 2 * w.height[0],
                               1 / sea.frequency(0), 2 * w.height[1], 1 / sea.frequency(1));
        case Sea::Kind::focused: {
            double crest = 0;
            for (int n = 0; n < w.count; ++n) crest += w.height[n];
            return fmt::format(
                "focused (NewWave), crest {:.4g} m at x = {:.4g} m and t = {:.4g} s, peak period {:.4g} s", crest,
                sea.focus_place, sea.focus_time, sea.peak_period);
        }
        default:
            return fmt::format("{}, significant height {:.4g} m, peak period {:.4g} s", name_of(sea.kind),
                               sea.significant_height, sea.peak_period);
    }
}

/// What neither order has: high waves are faster. As far as a regular wave as high as the focus would be ahead of it
/// (measured: docs/results/seas.md).
std::string third_order_text(const Scene& scene, const WaveScales& w) {
    const Sea& sea = *scene.sea;
    const double k = 2 * std::numbers::pi / w.length, linear = std::sqrt(sea.gravity / k * std::tanh(k * sea.depth()));
    double faster = 0;
    try {
        faster = regular_wave({.height = w.height,
                               .length = w.length,
                               .depth = sea.depth(),
                               .gravity = sea.gravity,
                               .theory = RegularWave::Theory::stream_function})
                         .speed_in_water /
                     linear -
                 1;
    } catch (const std::domain_error& e) { return fmt::format("  third     order: {}\n", e.what()); }
    constexpr double comes_apart = 0.05;  // peak periods; at 0.03 the crest is 4 to 9 % lower, at 0.12 a quarter
    const Box& open = scene.domain.undamped;  // a stream begins calm
    const double way = std::abs(sea.focus_place - (w.comes_from_low_x ? open.min : open.max).x()),
                 group = group_speed_ratio(k * sea.depth()) * linear,
                 on_the_way = sea.waves.stream == 0 ? sea.focus_time : way / (group + w.direction * sea.waves.stream),
                 early = faster * on_the_way * w.period / sea.peak_period;  // crests pass a gauge faster in a stream
    return fmt::format(
        "  third     order, left out too: a regular wave as high as the focus is {:.2g} % faster than by linear "
        "theory, "
        "so that its crests come about {:.2g} s earlier{}\n",
        100 * faster, early, early > comes_apart * w.period ? " (!) so high a group comes apart before its focus" : "");
}

/// A sum of waves, and what it leaves out.
std::string sea_text(const Scene& scene) {
    const Sea& sea = *scene.sea;
    const WaveScales w = wave_scales(scene);
    const double depth = sea.depth(), between = between_zones(scene), size = scene.resolution.near_hull;
    const SecondOrderShare left = left_out_by_first_order(sea);
    const char* where = where_it_runs(scene);
    std::string out = fmt::format("wave        {}, towards {}x\n", what_it_is(sea), w.direction > 0 ? "+" : "-");
    const int last = sea.waves.count - 1;
    out += fmt::format("  theory    sum of {} linear waves of {:.4g} to {:.4g} s", sea.waves.count,
                       1 / sea.frequency(0), 1 / sea.frequency(last));
    if (sea.kind == Sea::Kind::bichromatic)
        out += fmt::format("; beats of {:.4g} s\n", sea.repeat_period);
    else
        out += fmt::format(
            "; it repeats itself after {:.4g} s ({:.3g} peak periods); {:.2g} % of the energy of the "
            "spectrum lies outside this band, which carries it too\n",
            sea.repeat_period, sea.repeat_period / w.period, 100 * sea.beyond);
    if (scene.motion.kind == Motion::Kind::stream)
        out += fmt::format(
            "  stream    {:.4g} m/s: {} waves, that at the peak met every {:.4g} s; the energy of the shortest that "
            "count runs at {:.4g} m/s past the hull, from {}\n",
            scene.motion.speed, w.direction > 0 ? "head" : "following", w.period, w.slowest,
            w.comes_from_low_x ? "ahead" : "behind");
    out += enters_text(scene);
    out += fmt::format(
        "  error     of first order: bound waves of second order have {:.2g} % of the significant height, "
        "{:.2g} % in the short and {:.2g} % in the long ones; they arise on the way, with free waves as "
        "high against them{}\n",
        100 * left.both(), 100 * left.sum, 100 * left.difference,
        left.both() > 0.2 ? " (!) too high for a sum of linear waves" : "");
    if (sea.kind == Sea::Kind::focused) {
        const double from = sea.focus_time - 2 * w.period, to = sea.focus_time + 2 * w.period;
        const Crest second = highest_crest(sea, sea.focus_place, from, to, true);
        out += fmt::format("  crest     by second order {:.4g} m at t = {:.4g} s\n", second.height, second.time) +
               third_order_text(scene, w);
    }
    out += fmt::format(
        "  regime    at the peak: H/L {:.3g}, k d {:.3g} ({} water), Ursell {:.3g}, {:.2g} % of the highest "
        "wave\n",
        w.height / w.length, 2 * std::numbers::pi / w.length * depth, depth_regime(w.length, depth),
        ursell_number(w.height, w.length, depth), 100 * w.height / highest_wave(w.length, depth));
    out += fmt::format(
        "  sizes     {:.3g} of near_hull in its height, {:.4g} in the length of {:.4g} m at the peak, {:.3g} "
        "in {:.4g} m, the shortest that count; {:.3g} lengths at the peak {}\n"
        "  run       {:.3g} peak periods",
        w.height / size, w.length / size, w.length, w.shortest / size, w.shortest, between / w.length, where,
        scene.run.duration / w.period);
    if (particles_run(scene))
        out += fmt::format("; artificial viscosity takes {:.2g} % of the particles' height at the peak {}",
                           100 * loss_by_artificial_viscosity(scene, between), where);
    return out + "\n";
}

}  // namespace

std::string wave_text(const Scene& scene) {
    if (scene.wave) return regular_wave_text(scene);
    return scene.sea ? sea_text(scene) : std::string();
}

}  // namespace tw
