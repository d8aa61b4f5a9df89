#include <fmt/format.h>

#include "scene/defaults.h"
#include "scene/effects/part.h"
#include "scene/water/quiet_layer.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_dynamic_pressure(const EffectQuestion& q) {
    const std::string why_not = no_quiet_layer(q.scene);
    const MovingBody* body = q.needed->on ? slowest_in_deep_water(q.scene) : nullptr;
    EffectChoice c = q.choice(body && why_not.empty() && !q.excluded->on);
    c.influence = influence("none", "none", "none");
    if (!body) {
        c.reason =
            "no body moves slowly through deep, viscous water, where the particles' drag would suffer from the "
            "weight of the water (numerics of the particle method)";
        return c;
    }
    const SlowBody s = slow_body(q.scene, *body);
    c.reason = fmt::format(
        "{} moves at about {} m/s (Re = {}), with a dynamic pressure of {} Pa under {} Pa of still water: {}",
        body->name, plain_number(s.speed, 2), plain_number(s.reynolds, 2), plain_number(s.dynamic, 2),
        plain_number(s.hydrostatic, 2),
        c.on              ? "the particles carry the pressure above that of water at rest"
        : why_not.empty() ? "the particles carry all of it, as the scene asks"
                          : "the particles carry all of it, because " + why_not);
    const std::string off = fmt::format("drag of {} about {} too large", body->name, per_cent(excess_of_drag(s)));
    c.influence = influence(c.on ? "without it " + off : off, "the same", "none");
    return c;
}

/// The particles' sound speed follows from the pressure that they carry, and physical viscosity takes the place of the
/// artificial one.
void settle_dynamic_pressure(Scene& scene, bool on) {
    if (!on) return;
    take_default(scene, "sph.c0", scene.sph.c0, [&] { return default_sound_speed(scene); });
    take_default(scene, "sph.alpha", scene.sph.alpha, [] { return 0.0; });
}

}  // namespace

EffectPart dynamic_pressure() {
    return {
        .name = "dynamic_pressure",
        .meaning = "Particles carry the pressure above that of water at rest, for slow bodies in deep, viscous water.",
        .solved = EffectPart::Solved::by_particles_only,
        .needs = "viscosity",
        .excludes = "air",
        .plan = plan_dynamic_pressure,
        .obstacle = no_quiet_layer,
        .settle = settle_dynamic_pressure};
}

}  // namespace tw::effect_parts
