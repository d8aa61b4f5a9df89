#include <fmt/format.h>

#include "methods/names.h"
#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_turbulence(const EffectQuestion& q) {
    EffectChoice c = q.choice(q.needed->on && q.flow.reynolds > 5e5);
    c.reason = fmt::format(
        "{}; {} (turbulent from 5e5 on){}", q.needed->on ? "follows viscosity" : "follows viscosity, which is off",
        reynolds_text(q.flow),
        c.on ? "; the closures differ: Smagorinsky in the particle method, k-omega SST in the mesh method" : "");
    c.influence = q.scene.hull ? influence("4 % of the pressure drag (measured on a planing hull, air at the transom)",
                                           "0.7 % (measured on the same hull)", "not measured")
                               : influence("not measured", "not measured", "not measured");
    c.cost = 0.37;
    return c;
}

}  // namespace

EffectPart turbulence() {
    return {.name = "turbulence",
            .meaning = "A turbulence closure: Smagorinsky among the particles, k-omega SST on the mesh.",
            .needs = "viscosity",
            .plan = plan_turbulence,
            .keys = {{.section = sph_method,
                      .name = "smagorinsky",
                      .range = {0, 1},
                      .hashed = SceneKey::Hashed::run,
                      .slot = slot(&Scene::sph, &SphOptions::smagorinsky),
                      .meaning = "Smagorinsky constant Cs of the particle method."}}};
}

}  // namespace tw::effect_parts
