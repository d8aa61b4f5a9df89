#pragma once
#include <vector>

#include "scene/scene.h"
#include "scene/section.h"

namespace tw {

/// Which physical effects both methods solve, decided from dimensionless numbers unless the section says "on" or "off":
/// viscosity, turbulence, surface_tension, air, compressibility, shifting. Throws InputError for an effect that is
/// asked for and that this version cannot solve on both sides. Sets scene.sph.shifting = 0 when shifting is off.
std::vector<EffectChoice> plan_effects(Scene& scene, Section& section);

/// Skin friction coefficient of a flat plate, ITTC 1957: 0.075 / (log10 Re - 2)^2; for Re > 1e4, else 0.
double ittc57(double reynolds);

}  // namespace tw
