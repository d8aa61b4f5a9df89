#include "scene/box/forcing_zones.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/box/box_walls.h"
#include "scene/box/oblique_wave.h"
#include "scene/effects/part.h"
#include "scene/refined_places.h"
#include "scene/water/tailwater.h"

namespace tw::effect_parts {
namespace {

std::string reason_of(const EffectQuestion& q, bool by_default) {
    const Scene& scene = q.scene;
    if (runs_obliquely(scene)) return "the wave is made and absorbed in zones at all four sides";
    if (scene.has_wave())
        return by_default ? "the wave is made in a zone at one end and absorbed in one at the other"
                          : "the stream is faster than the waves, which enter with it; nothing runs upstream";
    if (scene.motion.kind != Motion::Kind::stream) return "the walls of a tank are meant to reflect waves";
    if (!(scene.water.gravity > 0) || !q.needed->on) return "without gravity there are no waves";
    if (by_default && tailwater(scene)) return "the water behind is held at the depth of [domain] downstream";
    if (by_default) return "waves can stand and travel upstream in this stream: its ends would reflect them";
    return scene.hull && planes(scene)
               ? fmt::format("Fr = {:.3g}: waves leave the domain before the sides reflect them", q.flow.froude)
               : "the stream is faster than the fastest wave in water as deep as the box: none travels upstream";
}

EffectChoice plan_forcing_zones(const EffectQuestion& q) {
    const bool by_default = (q.scene.has_wave() && q.scene.motion.kind != Motion::Kind::stream) ||
                            has_zones_by_default(q.scene, q.needed->on ? q.scene.water.gravity : 0);
    EffectChoice c = q.choice(by_default);
    c.reason = reason_of(q, by_default);
    c.influence = by_default
                      ? influence("a multiple of it, growing with time", "as the level drifts", "waves at the ends")
                      : influence("below 1 %", "below 1 %", "waves near the sides");
    const Box &all = q.scene.domain.box, &open = q.scene.domain.undamped;
    const double fewer = has_coarse_zones(q.scene) ? std::exp2(q.scene.domain.dimensions) : 1;
    c.cost = (all.volume() / open.volume() - 1) / fewer + 0.01;
    if (q.scene.has_wave() && by_default) c.influence = influence("100 %", "100 %", "the wave itself");
    return c;
}

/// A wave is to keep its height on its way through the tank. Lost in 0.6 of its lengths at ten particles in 0.1 of them
/// (docs/decisions/088-waves.md): 5 % with the other scenes' alpha and kernel, 1 to 2 % with these.
void settle_forcing_zones(Scene& scene, bool on) {
    if (!on || !scene.has_wave()) return;
    take_default(scene, "sph.alpha", scene.sph.alpha, [] { return 0.001; });
    take_default(scene, "sph.h_over_dp", scene.sph.h_over_dp, [] { return 2.0; });
}

}  // namespace

EffectPart forcing_zones() {
    return {.name = "forcing_zones",
            .older = "damping_layers",
            .meaning =
                "Zones along the outer faces that draw the water to the undisturbed flow and so absorb waves; in a "
                "stream outside the box, in a tank inside.",
            .needs = "gravity",
            .plan = plan_forcing_zones,
            .settle = settle_forcing_zones,
            .keys = {{.section = "domain",
                      .name = "downstream",
                      .unit = "m",
                      .range = positive,
                      .hashed = SceneKey::Hashed::scene,
                      .slot = slot(&Scene::zones, &ZoneOptions::downstream),
                      .fallback = "as ahead",
                      .meaning = "Depth of the water where a stream without a hull leaves, behind a weir, a gate or a "
                                 "jump; its speed there is that with which as much leaves as enters.",
                      .later = true},
                     {.section = "tank",
                      .name = "absorbing",
                      .kind = SceneKey::Kind::choice,
                      .choices = {"all", "x", "y", "x_min", "x_max", "y_min", "y_max"},
                      .hashed = SceneKey::Hashed::scene,
                      .slot = slot(&Scene::zones, &ZoneOptions::absorbing),
                      .meaning = "Which walls of a tank have a zone inside that absorbs waves.",
                      .later = true},
                     {.section = "tank",
                      .name = "wave_length",
                      .unit = "m",
                      .range = positive,
                      .hashed = SceneKey::Hashed::scene,
                      .slot = slot(&Scene::zones, &ZoneOptions::wave_length),
                      .fallback = "of the body that oscillates most slowly, else an eighth of the tank",
                      .meaning = "Length of the waves that the zones of a tank absorb, and their width.",
                      .later = true}}};
}

}  // namespace tw::effect_parts
