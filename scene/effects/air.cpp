#include <fmt/format.h>

#include <algorithm>

#include "methods/names.h"
#include "scene/effects/part.h"
#include "scene/water/water_blocks.h"

namespace tw::effect_parts {
namespace {

/// The cushion of air under a flat plate matters below about 3 degrees of deadrise (Verhagen 1967). Among the particles
/// the gas costs its own particles, and its sound speed sets the time step.
EffectChoice plan_air(const EffectQuestion& q) {
    const Scene& scene = q.scene;
    EffectChoice c = q.choice(false);
    const double water = water_volume(scene);  // of a sliver there are no particles
    const double gas = water > 0 ? air_volume(scene) / water : 0,
                 steps = std::max(1.0, (scene.sph.air_c0 + q.flow.speed) / (scene.sph.c0 + q.flow.speed));
    c.reason = fmt::format(
        "density ratio {:.2g}: {}; an air cushion matters at impacts with less than 3 deg of deadrise (rho_a U^2 = "
        "{:.2g} Pa here)",
        scene.water.air_density / scene.water.density,
        c.on
            ? fmt::format("a gas of sound speed {:g} m/s under a lid in the particle method, incompressible air in the "
                          "mesh method; only the force of the water is compared",
                          scene.sph.air_c0)
            : "because of its cost the particle method solves it only on request; the mesh method always does, and "
              "only the force of the water is compared",
        scene.water.air_density * q.flow.speed * q.flow.speed);
    c.influence = scene.hull ? influence("10 % (measured on dry topsides, shown beside the compared force)",
                                         "3 to 5 % (measured on the same)",
                                         "drops are slowed; sheets thinner than a cell survive")
                             : influence("none", "enclosed pockets collapse without it", "not measured");
    c.cost = (1 + gas) * steps - 1;
    return c;
}

std::string obstacle_of_air(const Scene& scene) {
    if (scene.motion.kind == Motion::Kind::stream)
        return "the particle method solves it in tanks only: in a stream the gas is enclosed, and its pressure loads "
               "the "
               "hull (measured: a sixth of the lift); expected \"off\" or \"auto\"";
    if (scene.sph.scheme != "kick_drift_kick" && scene.sph.scheme != "symplectic_euler")
        return "needs a time step with a single evaluation: [sph] scheme = \"kick_drift_kick\" or \"symplectic_euler\"";
    return "";
}

}  // namespace

EffectPart air() {
    return {.name = "air",
            .meaning = "Air as a second phase of the particle method, in tanks; the mesh method always has it.",
            .solved = EffectPart::Solved::by_particles_only,
            .plan = plan_air,
            .obstacle = obstacle_of_air,
            .keys = {{.section = sph_method,
                      .name = "air_c0",
                      .unit = "m/s",
                      .range = {0, 1e5, true},
                      .hashed = SceneKey::Hashed::run,
                      .slot = slot(&Scene::sph, &SphOptions::air_c0),
                      .meaning = "Sound speed of the air; that of real air is 343 m/s, a smaller one is cheaper and "
                                 "makes the air softer."}}};
}

}  // namespace tw::effect_parts
