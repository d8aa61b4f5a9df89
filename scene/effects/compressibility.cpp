#include <fmt/format.h>

#include "scene/effects/part.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_compressibility(const EffectQuestion& q) {
    const FlowNumbers& n = q.flow;
    EffectChoice c = q.choice(false);
    c.reason = fmt::format("Ma = {:.2g} in real water (1480 m/s), {:.2g} in the particle method ({} equation of state)",
                           n.speed / 1480, n.mach, q.scene.sph.equation_of_state);
    const std::string share = per_cent(n.mach * n.mach);
    // Of the particle method's water: real water and interFoam's have none that matters.
    c.bounds =
        equal_shares({"drag", "lift", "splash", "pressure", "peak", "height", "level", "arrival", "impulse", "motion"},
                     n.mach * n.mach, "Ma^2 of the particle method");
    for (EffectBound& b : c.bounds) b.elements = "particles";
    c.influence = influence(share, share, share,
                            n.mach > 0.11 ? "density error of the particle method above 1 %: raise [sph] c0"
                                          : "impact peaks shorter than h/c0 are not resolved");
    return c;
}

std::string obstacle_of_compressibility(const Scene&) {
    return "water is solved as (nearly) incompressible by both methods; expected \"off\" or \"auto\"";
}

}  // namespace

EffectPart compressibility() {
    return {.name = "compressibility",
            .meaning = "Compressibility of real water; it cannot be on in this version.",
            .solved = EffectPart::Solved::by_neither,
            .plan = plan_compressibility,
            .obstacle = obstacle_of_compressibility};
}

}  // namespace tw::effect_parts
