#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/box/oblique_wave.h"
#include "scene/read/read.h"

namespace tw {
namespace {

constexpr double slowest_met = 0.3;                   ///< of the wave's own speed
const double nearly_following = -std::sqrt(2.0 / 3);  ///< cos b

}  // namespace

void refuse_oblique_surroundings(const Scene& scene, Sections& s, double degrees) {
    const auto refuse = [&](const char* key, const std::string& why) {
        s.wave.fail(key, fmt::format("{:.4g} degrees: {}", degrees, why));
    };
    if (scene.motion.kind != Motion::Kind::stream)
        refuse(
            "direction",
            "a tank's sides are walls to oblique waves; expected 0 (towards +x) or \"180 deg\" (towards -x) and a body "
            "turned by its mesh, or [motion] kind = \"stream\"");
    if (scene.domain.dimensions == 2)
        refuse("direction",
               "two dimensions have no oblique waves; expected 0 (a head wave), \"180 deg\" (a following wave), or "
               "[domain] dimensions = 3");
    if (scene.hull && scene.hull->half)
        refuse(
            "direction",
            "the flow about a hull in oblique waves is not symmetric; expected [hull] half = false, 0 (a head wave) or "
            "\"180 deg\" (a following wave)");
    if (scene.wave_asked.spectrum != "regular")
        refuse("direction",
               "sums of waves are made as head and following waves alone; expected 0, \"180 deg\", or spectrum = "
               "\"regular\"");
    if (s.domain.has("sides") && scene.zones.sides != "open")
        s.domain.fail("sides", "walls would reflect an oblique wave; remove this key, or write \"open\"");
}

void check_oblique_wave(const Scene& scene, Sections& s, const std::string& size) {
    const RegularWave& wave = *scene.wave;
    const double U = scene.motion.speed, along = wave.sum.direction, c = wave.speed_in_water,
                 group = wave.group_speed_in_water();
    if (along < nearly_following && U > slowest_passing * group * -along)
        s.wave.fail(
            size,
            fmt::format("the energy of this wave, {:.4g} m long, runs at {:.4g} m/s along x against the stream "
                        "of {:.4g} m/s, which nearly stops it or brings it from ahead with longer waves; "
                        "expected a stream of at most {:.4g} m/s, a longer wave, or a direction of at most {:.4g} "
                        "degrees to either side",
                        wave.length, group * -along, U, slowest_passing * group * -along,
                        std::acos(nearly_following) * 180 / std::numbers::pi));
    if (c + U * along < slowest_met * c)
        s.wave.fail(size,
                    fmt::format("the stream of {:.4g} m/s carries the crests of this wave, {:.4g} m long, back so fast "
                                "that it is met every {:.4g} s ({:.4g} s in the water); expected a stream of at most "
                                "{:.4g} m/s, a longer wave, or one nearer to the beam",
                                U, wave.length, wave.encounter_period(), wave.period_in_water(),
                                (1 - slowest_met) * c / -along));
}

}  // namespace tw
