#include "sph_solver/effects/registry.h"

namespace tw {

EffectOptions effects_of(const Scene& scene, const Surroundings& around, const LevelSetup& water) {
    EffectOptions on;
#define TW_ASKED(name) effect_of_scene::name(scene, around, water, on);
    TW_EFFECTS(TW_ASKED)
#undef TW_ASKED
    return on;
}

}  // namespace tw
