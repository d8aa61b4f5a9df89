#include <fmt/format.h>

#include "scene/effects/part.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

/// Below it a plate's boundary layer is laminar for a good part of its length, and the line, of turbulent layers, is too
/// high (Schlichting, Boundary-Layer Theory, chapter 21).
constexpr double turbulent_from = 5e5;

bool is_solved(const EffectQuestion& q) { return q.excluded->on; }

std::string obstacle_of_friction(const Scene& scene) {
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream)
        return "the line is for a hull in a stream; viscosity = \"on\" solves friction elsewhere";
    if (!(scene.water.kinematic_viscosity > 0)) return "the viscosity of the water is zero; set [water] viscosity";
    return "";
}

EffectChoice plan_friction(const EffectQuestion& q) {
    const FlowNumbers& n = q.flow;
    const bool can = obstacle_of_friction(q.scene).empty();
    EffectChoice c = q.choice(can && !is_solved(q) && n.reynolds > turbulent_from);
    const double R = can ? ittc57(n.reynolds) * n.head * n.wetted_area : 0;
    c.reason = !can           ? "no hull in a stream"
               : is_solved(q) ? "the effect viscosity solves friction"
                              : fmt::format(
                                    "Re = {:.3g}: turbulent from {:g} on; C_F = {:.3g} (ITTC 1957) on what each "
                                    "method finds wet",
                                    n.reynolds, turbulent_from, ittc57(n.reynolds));
    c.influence =
        can ? influence(fmt::format("about {} N on what is wet at rest{}", plain_number(R), c.on ? "" : ", left out"),
                        "none", "none", "added to the pressure drag of both methods alike; it does not act on the flow")
            : influence("none", "none", "none");
    c.cost = 0;
    return c;
}

}  // namespace

EffectPart friction() {
    return {.name = "friction",
            .meaning = "Friction on a hull by the line for flat plates, in its total drag.",
            .excludes = "viscosity",
            .plan = plan_friction,
            .obstacle = obstacle_of_friction};
}

}  // namespace tw::effect_parts
