#pragma once
#include "scene/scene.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/effects/effects.h"

// The one list of effects that are parts of their own, in the order of their calls. Each line names a function of
// namespace tw::effect_of_scene, defined in NAME.cpp, that puts the effect on the list where the scene has it on.
#define TW_EFFECTS(effect)                                                                                    \
    effect(ventilation) effect(acoustic_damping) effect(cavitation) effect(viscosity) effect(surface_tension) \
        effect(dynamic_pressure) effect(forcing_zones) effect(moving_tank)

namespace tw::effect_of_scene {

#define TW_DECLARED(name) \
    void name(const Scene& scene, const Surroundings& around, const LevelSetup& water, EffectOptions& on);
TW_EFFECTS(TW_DECLARED)
#undef TW_DECLARED

}  // namespace tw::effect_of_scene
