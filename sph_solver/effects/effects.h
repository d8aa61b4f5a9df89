#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "sph_solver/effects/acoustic_damping.h"
#include "sph_solver/effects/cavitation.h"
#include "sph_solver/effects/damping_layers.h"
#include "sph_solver/effects/effect.h"
#include "sph_solver/effects/moving_tank.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/viscosity.h"

namespace tw {

/// The effects that are on, with their parameters.
struct EffectOptions {
    std::optional<Viscosity> viscosity;
    std::optional<SurfaceTension> surface_tension;
    std::optional<AcousticDamping> acoustic_damping;
    std::optional<Cavitation> cavitation;
    std::optional<DampingLayers> damping_layers;
    bool moving_tank = false;  ///< the surroundings have a frame that moves
};

/// One line each; their order is that of their calls. TW_WITHOUT_EFFECTS makes a build that lacks them, to compare with
/// (tests/verification/off_is_free).
inline std::vector<std::unique_ptr<Effect>> make_effects([[maybe_unused]] const EffectOptions& on) {
    std::vector<std::unique_ptr<Effect>> effects;
#ifndef TW_WITHOUT_EFFECTS
    if (on.acoustic_damping) effects.push_back(make_acoustic_damping(*on.acoustic_damping));
    if (on.cavitation) effects.push_back(make_cavitation(*on.cavitation));
    if (on.viscosity) effects.push_back(make_viscosity(*on.viscosity));
    if (on.surface_tension) effects.push_back(make_surface_tension(*on.surface_tension));
    if (on.damping_layers) effects.push_back(make_damping_layers(*on.damping_layers));
    if (on.moving_tank) effects.push_back(make_moving_tank());
#endif
    return effects;
}

}  // namespace tw
