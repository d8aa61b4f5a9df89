#include <fmt/format.h>

#include "scene/effects/part.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

/// Friction counts for drag; the question is whether the particles can resolve the layer that makes it: laminar
/// boundary layer 5 L / sqrt(Re) at the end of the hull (Blasius 1908) in at least five spacings.
EffectChoice plan_viscosity(const EffectQuestion& q) {
    const Scene& scene = q.scene;
    const FlowNumbers& n = q.flow;
    const double dp = scene.resolution.near_hull;
    const double layer = std::isfinite(n.reynolds) ? 5 * n.length / std::sqrt(n.reynolds) : 0;
    EffectChoice c = q.choice(layer > 5 * dp);
    const int dimensions = scene.domain.dimensions;
    const double numerical = scene.sph.alpha * scene.sph.h_over_dp * dp * scene.sph.c0 / (2 * (dimensions + 2));
    if (scene.water.kinematic_viscosity > 0) {
        const double ratio = numerical / scene.water.kinematic_viscosity;
        c.reason = fmt::format(
            "{}: a laminar boundary layer is {:.2g} spacings thick ({}); the numerical viscosity of the particle "
            "method is {} times that of the water",
            reynolds_text(n), layer / dp, layer > 5 * dp ? "resolved" : "at least five are needed to resolve it",
            plain_number(ratio, 2));
        if (c.on && ratio > 10) c.reason += ", so its friction is no prediction";
    } else {
        c.reason = fmt::format("{}; the numerical one of the particle method is {} m2/s", reynolds_text(n),
                               plain_number(numerical, 2));
    }
    if (n.wetted_area > 0) {
        const double cf = std::isfinite(n.reynolds) ? ittc57(n.reynolds) : 0;
        c.influence = influence(fmt::format("about {} N of friction (ITTC 1957, Cf = {:.3g}, wetted area {:.3g} m2){}",
                                            plain_number(cf * n.head * n.wetted_area), cf, n.wetted_area,
                                            c.on ? "" : ", left out by both methods"),
                                "below 1 %", "below 1 %");
    } else {
        c.influence = influence(
            "wall friction", "none",
            "without it fronts on dry floors run 14 % too fast and press up to 55 % too hard on the wall behind "
            "(measured)");
    }
    c.cost = 0.20;
    return c;
}

std::string obstacle_of_viscosity(const Scene& scene) {
    return scene.water.kinematic_viscosity > 0 ? "" : "the viscosity of the water is zero; set [water] viscosity";
}

}  // namespace

EffectPart viscosity() {
    return {.name = "viscosity",
            .meaning = "Viscous stresses in the water.",
            .plan = plan_viscosity,
            .obstacle = obstacle_of_viscosity};
}

}  // namespace tw::effect_parts
