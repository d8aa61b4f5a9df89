#include <fmt/format.h>

#include <algorithm>

#include "scene/effects/part.h"
#include "text/plain_number.h"

namespace tw::effect_parts {
namespace {

/// On slip walls a front runs too fast over a dry floor, up to 14 % against measurements: it arrives 14 % too early, is 14 %
/// too thin, and what it strikes with and rises by, its speed squared, is 1 - 1/1.14^2 too much. Means of the pressure on
/// the wall behind are up to 55 % too high in the corner, where friction keeps a roller, and up to 30 % too low above it
/// (docs/results/dam_break_pressure.md;
/// gauges 0.01, 0.05, 0.10 and 0.27 of the water's height above the floor).
constexpr double front_too_fast = 0.14, wall_too_hard = 0.55, wall_too_soft = 0.30;
constexpr double corner = 0.10, above_corner = 0.26;  ///< of the height of the water that is let go [-]

/// Whether a gauge sits on a side wall of the tank.
bool on_a_wall(const Scene& scene, const Vec3& place) {
    const Box& tank = scene.domain.box;
    const auto near = [&](double a, double b) { return std::abs(a - b) <= 0.5 * scene.resolution.near_hull; };
    return near(place.x(), tank.min.x()) || near(place.x(), tank.max.x()) ||
           (scene.domain.dimensions == 3 && (near(place.y(), tank.min.y()) || near(place.y(), tank.max.y())));
}

std::vector<EffectBound> of_dry_floors(const Scene& scene, double released) {
    const std::string source = "measured: a dam break on a wall and its front";
    const double slower = 1 - 1 / ((1 + front_too_fast) * (1 + front_too_fast)), softer = 1 - 1 / (1 + wall_too_hard),
                 harder = 1 / (1 - wall_too_soft) - 1;
    std::vector<EffectBound> bounds{
        {.of = "arrival", .below = 0, .above = front_too_fast, .source = source},
        {.of = "height", .below = slower, .above = front_too_fast, .source = source},
        {.of = "impulse", .below = slower, .above = 0, .source = source},
        {.of = "peak", .below = slower, .above = 0, .source = source},
        {.of = "pressure", .below = slower, .above = 0, .source = source},
    };
    for (const PressureProbe& p : scene.sampling.pressure) {
        if (!on_a_wall(scene, p.place)) continue;
        const double height = (p.place.z() - scene.domain.box.min.z()) / released;
        bounds.push_back({.of = "pressure:" + p.name,
                          .below = height < above_corner ? softer : 0,
                          .above = height > corner ? harder : 0,
                          .source = source});
    }
    return bounds;
}

/// Where water stands on the floor, friction is felt within the boundary layer alone: its displacement thickness over the
/// height of the water, 1.72 / sqrt(Re) (Blasius 1908).
std::vector<EffectBound> of_wet_floors(const FlowNumbers& n) {
    if (!std::isfinite(n.reynolds)) return {};
    return equal_shares({"pressure", "peak", "height", "level", "arrival", "impulse", "motion"},
                        std::min(1.0, 1.72 / std::sqrt(n.reynolds)), "1.72 / sqrt(Re), laminar displacement thickness");
}

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
        c.influence = influence(
            fmt::format("about {} N of friction (ITTC 1957, Cf = {:.3g}, wetted area at rest {:.3g} m²){}",
                        plain_number(cf * n.head * n.wetted_area), cf, n.wetted_area,
                        c.on ? "" : ", not solved: what the effect friction adds is taken on what each run finds wet"),
            "below 1 %", "below 1 %");
    } else {
        c.influence = influence(
            "wall friction", "none",
            "without it fronts on dry floors run 14 % too fast and press up to 55 % too hard on the wall behind "
            "(measured)");
        if (!scene.hull) c.bounds = n.dry_floor > 0 ? of_dry_floors(scene, n.released) : of_wet_floors(n);
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
