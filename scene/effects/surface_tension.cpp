#include <fmt/format.h>

#include <algorithm>

#include "scene/effects/part.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

EffectChoice plan_surface_tension(const EffectQuestion& q) {
    const FlowNumbers& n = q.flow;
    EffectChoice c = q.choice(n.weber < 100);
    c.cost = 0.23;
    if (!(q.scene.water.surface_tension > 0)) {
        c.reason = "the water has no surface tension";
        c.influence = influence("none", "none", "none");
        return c;
    }
    c.reason = fmt::format("We = {:.3g}, Bo = {:.3g}; at the finest size of {:.3g} m We = {:.3g}: {}", n.weber, n.bond,
                           q.scene.resolution.near_hull, n.weber_dp,
                           n.weber < 100      ? "it acts on the whole flow"
                           : n.weber_dp > 100 ? "inertia dominates at every resolved scale"
                                              : "it acts only on the finest resolved sheets and drops");
    const std::string share = per_cent(std::min(1.0, 1 / n.weber));
    if (!q.scene.hull)
        c.bounds = equal_shares({"pressure", "peak", "height", "level", "arrival", "impulse", "motion"},
                                std::min(1.0, 1 / n.weber), "1 / We");
    c.influence = influence(share, share,
                            fmt::format("drops smaller than {} m are held together by it",
                                        plain_number(12 * q.scene.water.surface_tension / (2 * n.head), 2)));
    return c;
}

std::string obstacle_of_surface_tension(const Scene& scene) {
    return scene.water.surface_tension > 0 ? ""
                                           : "the surface tension of the water is zero; set [water] surface_tension";
}

}  // namespace

EffectPart surface_tension() {
    return {.name = "surface_tension",
            .meaning = "Surface tension between water and air.",
            .plan = plan_surface_tension,
            .obstacle = obstacle_of_surface_tension};
}

}  // namespace tw::effect_parts
