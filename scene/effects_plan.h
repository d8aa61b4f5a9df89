#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/section.h"

namespace tw {

/// Which physical effects are solved, decided from dimensionless numbers (Re, We, Bo, Fr, Ma, cavitation number) unless
/// the section says "on" or "off"; the names are in scene/README.md. What "auto" chooses, both methods solve; what only
/// the particle side can (cavitation, damping layers, acoustic damping) is on only when asked for, and says so. Throws
/// InputError for an effect that this version cannot solve. Sets scene.sph.shifting = 0 when shifting is off and
/// scene.water.gravity = 0 when gravity is; defaults of domain and times are those of the scene with gravity.
std::vector<EffectChoice> plan_effects(Scene& scene, Section& section);

/// Every effect of the plan, in its order.
const std::vector<std::string>& effect_names();
/// The effect without which this one cannot be on (no_slip and turbulence need viscosity); empty: none.
std::string effect_needed_by(const std::string& name);
/// True for effects that the mesh side does not know: there, switching them changes nothing.
bool acts_among_particles_only(const std::string& name);

/// Skin friction coefficient of a flat plate, ITTC 1957: 0.075 / (log10 Re - 2)^2; for Re > 1e4, else 0.
double ittc57(double reynolds);

}  // namespace tw
