#include <fmt/format.h>

#include "methods/names.h"
#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_acoustic_damping(const EffectQuestion& q) {
    EffectChoice c = q.choice(false);
    c.reason = fmt::format(
        "a bulk viscosity of {:g} c0 h damps the sound waves of the particle method; it lowers impact peaks, so it is "
        "on "
        "only on request",
        q.scene.sph.acoustic_damping);
    c.influence =
        influence("none in the mean", "none in the mean", "none", "peak pressures fall, impulses are unchanged");
    c.cost = 0.01;
    return c;
}

}  // namespace

EffectPart acoustic_damping() {
    return {.name = "acoustic_damping",
            .meaning = "Damping of sound waves in the particle method by a bulk viscosity.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_acoustic_damping,
            .keys = {{.section = sph_method,
                      .name = "acoustic_damping",
                      .range = {0, 2, true},
                      .hashed = SceneKey::Hashed::run,
                      .slot = slot(&Scene::sph, &SphOptions::acoustic_damping),
                      .meaning = "Coefficient alpha2 of the bulk viscosity.",
                      .older = "acoustic_damper"}}};
}

}  // namespace tw::effect_parts
