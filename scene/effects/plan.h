#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "text/section.h"

namespace tw {

/// Decides for every effect of the registry whether it is solved: as the section says, else from dimensionless numbers
/// (Re, We, Bo, Fr, Ma, cavitation number). What "auto" chooses, both methods solve; what only the particle method can
/// solve is on only on request, and its reason says so. Throws InputError for an effect that cannot be on in this
/// scene. Changes the numbers of the scene that a choice sets: gravity off, shifting off. `asked`: what the section says of
/// an effect, in whatever spelling; nothing for "auto".
std::vector<EffectChoice> plan_effects(Scene& scene, Section& section,
                                       const std::function<std::optional<bool>(const std::string& effect)>& asked);

}  // namespace tw
