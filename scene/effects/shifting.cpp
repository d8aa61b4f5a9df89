#include "methods/names.h"
#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_shifting(const EffectQuestion& q) {
    EffectChoice c = q.choice(q.scene.sph.shifting > 0);
    c.reason = c.on
                   ? "keeps particles from lining up along the stream and opening gaps under the hull (numerics of the "
                     "particle method; near a free surface only along it)"
                   : "switched off in the scene";
    c.influence = influence("not measured", "-10 % (measured on a planing hull: +10 % without it)", "not measured");
    c.cost = 0.05;
    return c;
}

void settle_shifting(Scene& scene, bool on) {
    if (!on) scene.sph.shifting = 0;
    if (on && scene.sph.shifting == 0) scene.sph.shifting = SphOptions{}.shifting;
}

}  // namespace

EffectPart shifting() {
    return {.name = "shifting",
            .meaning = "Particles are moved towards even spacing.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_shifting,
            .settle = settle_shifting,
            .keys = {{.section = sph_method,
                      .name = "shifting",
                      .range = {0, 3},
                      .hashed = SceneKey::Hashed::run,
                      .slot = slot(&Scene::sph, &SphOptions::shifting),
                      .meaning = "Coefficient of the shifting; 0: off."}},
            .in_the_throughput = true};
}

}  // namespace tw::effect_parts
