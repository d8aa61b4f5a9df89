#include <fmt/format.h>

#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_gravity(const EffectQuestion& q) {
    EffectChoice c = q.choice(true);
    c.reason = fmt::format("Fr = {:.3g} on the wetted length", q.flow.froude);
    const std::string share = per_cent(1 / (q.flow.froude * q.flow.froude));
    c.influence = influence(share, share, "how far the water falls back");
    return c;
}

/// The domain stays that of the scene with gravity; a stream without it has no waves to wait for and no water that falls
/// (read_scene.cpp).
void settle_gravity(Scene& scene, bool on) {
    if (!on) scene.water.gravity = 0;
}

}  // namespace

EffectPart gravity() {
    return {.name = "gravity", .meaning = "Weight of the water.", .plan = plan_gravity, .settle = settle_gravity};
}

}  // namespace tw::effect_parts
