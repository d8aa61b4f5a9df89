#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/effects/part.h"
#include "scene/water/capillary.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

// What drops want, measured (docs/results/air.md): with h/dp = 1.55 a drop's period is 20 % off, and with the
// usual artificial viscosity of 0.01 a drop loses 7 % of its water and makes energy. That viscosity is alpha c0 h: at a
// sound speed that the water's depth asks for, the same one is a smaller alpha (0.1 there makes molasses of the water and
// put the trim of a floating box off by 19 %).
constexpr double wanted_h_over_dp = 2, wanted_alpha = 0.1;

void settle_surface_tension(Scene& scene, bool on) {
    if (!on) return;
    take_default(scene, "sph.h_over_dp", scene.sph.h_over_dp, [] { return wanted_h_over_dp; });
    const double of_surface = 10 * capillary_speed(scene);
    take_default(scene, "sph.c0", scene.sph.c0, [&] { return std::max(scene.sph.c0, of_surface); });
    take_default(scene, "sph.alpha", scene.sph.alpha,
                 [&] { return std::max(scene.sph.alpha, wanted_alpha * std::min(1.0, of_surface / scene.sph.c0)); });
}

/// What the particles take with the effect on, and what that costs beside the effect itself.
std::string numerics_in_words(const Scene& scene) {
    Scene with = scene;
    EffectChoice on;
    on.name = "surface_tension", on.on = true;
    with.effects = {on};
    settle_surface_tension(with, true);
    const int d = scene.domain.dimensions;  // pairs grow with h^d, steps with c0/h
    const double times = std::pow(with.sph.h_over_dp / scene.sph.h_over_dp, d - 1) * with.sph.c0 / scene.sph.c0;
    return fmt::format(
        "; a drop keeps its period, its water and its energy only with h/dp = {:g}, alpha = {:g} and a sound speed of "
        "ten "
        "times its capillary speed ({} m/s at this size): the particles take h/dp = {:g}, alpha = {} and c0 = {} m/s "
        "(what [sph] gives stays), which makes the run {} times as long",
        wanted_h_over_dp, wanted_alpha, plain_number(capillary_speed(with), 2), with.sph.h_over_dp,
        plain_number(with.sph.alpha, 2), plain_number(with.sph.c0), plain_number(times, 2));
}

EffectChoice plan_surface_tension(const EffectQuestion& q) {
    const FlowNumbers& n = q.flow;
    const double held_flat = std::max(n.weber, n.bond);  // by inertia or by the water's weight, over the tension
    EffectChoice c = q.choice(held_flat < 100);
    c.cost = 0.23;
    if (!(q.scene.water.surface_tension > 0)) {
        c.reason = "the water has no surface tension";
        c.influence = influence("none", "none", "none");
        return c;
    }
    c.reason = fmt::format("We = {:.3g}, Bo = {:.3g}; at the finest size of {:.3g} m We = {:.3g}: {}", n.weber, n.bond,
                           q.scene.resolution.near_hull, n.weber_dp,
                           held_flat < 100    ? "it acts on the whole flow"
                           : n.weber < 100    ? "gravity holds the surface"
                           : n.weber_dp > 100 ? "inertia dominates at every resolved scale"
                                              : "it acts only on the finest resolved sheets and drops");
    if (c.on) c.reason += numerics_in_words(q.scene);
    const std::string share = per_cent(std::min(1.0, 1 / held_flat));
    if (!q.scene.hull)
        c.bounds = equal_shares({"pressure", "peak", "height", "level", "arrival", "impulse", "motion"},
                                std::min(1.0, 1 / held_flat), "1 / We");
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
            .obstacle = obstacle_of_surface_tension,
            .settle = settle_surface_tension};
}

}  // namespace tw::effect_parts
