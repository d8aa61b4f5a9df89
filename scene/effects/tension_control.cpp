#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_tension_control(const EffectQuestion& q) {
    EffectChoice c = q.choice(false);
    c.reason =
        "uses p_j - p_i instead of p_j + p_i where water away from surfaces is under tension (numerics of the particle "
        "method); pair forces no longer cancel there, so it is on only on request";
    c.influence = influence("not measured", "not measured", "none: it does not act near free surfaces");
    return c;
}

}  // namespace

EffectPart tension_control() {
    return {.name = "tension_control",
            .meaning = "Keeps particles from clumping where the water is under tension.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_tension_control};
}

}  // namespace tw::effect_parts
