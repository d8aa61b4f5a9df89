#include "scene/effects/registry.h"

#include <fmt/format.h>

#include <stdexcept>

#include "methods/methods.h"

// The one list of effects, in the order of the plan. Each line names a function `EffectPart NAME()` of namespace
// tw::effect_parts, defined in scene/effects/NAME.cpp.
#define TWINWAKE_EFFECTS(part)                                                                     \
    part(viscosity) part(friction) part(no_slip) part(turbulence) part(surface_tension) part(air)  \
        part(compressibility) part(gravity) part(ventilation) part(cavitation) part(forcing_zones) \
            part(acoustic_damping) part(shifting) part(tension_control) part(dynamic_pressure)

namespace tw {

namespace effect_parts {
#define TWINWAKE_DECLARED(part) EffectPart part();
TWINWAKE_EFFECTS(TWINWAKE_DECLARED)
}  // namespace effect_parts

const std::vector<EffectPart>& effects() {
#define TWINWAKE_MADE(part) effect_parts::part(),
    static const std::vector<EffectPart> parts{TWINWAKE_EFFECTS(TWINWAKE_MADE)};
    return parts;
}

std::vector<std::string> effect_names() {
    std::vector<std::string> names;
    for (const EffectPart& part : effects()) names.push_back(part.name);
    return names;
}

std::string present_name(const std::string& name) {
    for (const EffectPart& part : effects())
        if (!part.older.empty() && part.older == name) return part.name;
    return name;
}

const EffectPart& effect_part(const std::string& name) {
    for (const EffectPart& part : effects())
        if (part.name == name) return part;
    throw std::logic_error("no effect is called " + name);
}

bool solves(const std::string& method, const EffectPart& effect) {
    return effect.solved == EffectPart::Solved::by_both_methods ||
           (effect.solved == EffectPart::Solved::by_particles_only && elements_of(method) == "particles");
}

std::string effects_text() {
    std::string text;
    const auto add = [&](EffectPart::Solved solved, const std::string& words) {
        std::string list;
        for (const EffectPart& part : effects())
            if (part.solved == solved) list += (list.empty() ? "" : ", ") + part.name;
        if (!list.empty()) text += words + ": " + list + ".\n";
    };
    add(EffectPart::Solved::by_both_methods, "Solved by both methods");
    add(EffectPart::Solved::by_particles_only, "Solved by the particle method only");
    add(EffectPart::Solved::by_neither, "Cannot be switched on in this version");
    for (const EffectPart& part : effects())
        if (!part.needs.empty()) text += fmt::format("{} needs {}.\n", part.name, part.needs);
    for (const EffectPart& part : effects())
        if (!part.excludes.empty()) text += fmt::format("{} is not for use with {}.\n", part.name, part.excludes);
    return text;
}

}  // namespace tw
