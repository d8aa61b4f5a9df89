#include <fmt/format.h>

#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_cavitation(const EffectQuestion& q) {
    const double number = q.flow.cavitation;
    EffectChoice c = q.choice(false);
    c.reason =
        fmt::format("cavitation number {:.3g}: the water cavitates where Cp falls below {:.3g}; {}", number, -number,
                    number > 2 ? "none is expected"
                               : "the mesh method has no pressure limit, so the particle method has one only on "
                                 "request");
    c.influence = number > 2 ? influence("none", "none", "none")
                             : influence("limits suction behind steps and edges", "the same", "none",
                                         c.on ? "only the particle method solves it"
                                              : "see the lowest pressure in the run record");
    c.cost = 0.01;
    return c;
}

SceneKey pressure(const char* name, double Water::*value, const char* meaning) {
    return {.section = "water",
            .name = name,
            .unit = "Pa",
            .range = {0, 1e9},
            .hashed = SceneKey::Hashed::scene,
            .slot = slot(&Scene::water, value),
            .meaning = meaning};
}

}  // namespace

EffectPart cavitation() {
    return {.name = "cavitation",
            .meaning = "Pressure in the water does not fall below the vapour pressure.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_cavitation,
            .keys = {pressure("atmospheric_pressure", &Water::atmospheric_pressure, "Pressure of the atmosphere."),
                     pressure("vapour_pressure", &Water::vapour_pressure, "Vapour pressure of the water.")}};
}

}  // namespace tw::effect_parts
