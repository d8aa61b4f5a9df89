#include <fmt/format.h>

#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_damping_layers(const EffectQuestion& q) {
    EffectChoice c = q.choice(false);
    c.reason = q.scene.motion.kind == Motion::Kind::stream
                   ? fmt::format("Fr = {:.3g}: {}", q.flow.froude,
                                 q.flow.froude > 1
                                     ? "waves leave the domain before the sides reflect them"
                                     : "the sides may reflect waves; the mesh method has no layers, so the domain is "
                                       "made wider instead")
                   : "the walls of a tank are meant to reflect waves";
    c.influence =
        influence("below 1 %", "below 1 %", "waves near the sides", c.on ? "only the particle method solves it" : "");
    c.cost = 0.01;
    return c;
}

}  // namespace

EffectPart damping_layers() {
    return {.name = "damping_layers",
            .meaning = "Layers along the outer faces that absorb waves.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_damping_layers};
}

}  // namespace tw::effect_parts
