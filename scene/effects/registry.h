#pragma once
#include <string>
#include <vector>

#include "scene/effects/part.h"

namespace tw {

/// Every effect, in the order of the plan; what an effect needs comes before it. The plan, the hash, the keys of
/// [effects], `--effect`, the shell completion, `ablate` and the scene reference all read this list.
const std::vector<EffectPart>& effects();
std::vector<std::string> effect_names();
/// The name of an effect that is called so, or was by an older version; others are left as they are.
std::string present_name(const std::string& name);
/// Throws std::logic_error for a name that no effect has.
const EffectPart& effect_part(const std::string& name);

/// Whether a method of methods/methods.h solves an effect where it is on.
bool solves(const std::string& method, const EffectPart& effect);

/// The names by what solves them, in sentences for help texts.
std::string effects_text();

}  // namespace tw
