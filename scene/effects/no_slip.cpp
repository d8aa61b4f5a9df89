#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_no_slip(const EffectQuestion& q) {
    EffectChoice c = q.choice(q.needed->on);
    c.reason = q.needed->on ? "follows viscosity: the water sticks to the walls"
                            : "follows viscosity, which is off: without it walls exert no friction";
    c.influence = influence("all of the friction", "below 1 %", "below 1 %");
    return c;
}

}  // namespace

EffectPart no_slip() {
    return {.name = "no_slip",
            .meaning = "Water sticks to hulls, obstacles and the walls of a tank instead of sliding along them.",
            .needs = "viscosity",
            .plan = plan_no_slip};
}

}  // namespace tw::effect_parts
