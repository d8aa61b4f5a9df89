#include "scene/box/box_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tw {
namespace {

constexpr double of_sides = 0.139, of_floor = 0.0148;
constexpr double largest_depth_froude = 0.9;  // of the formula for the resistance

double wetted_length(const Hull& hull) { return hull.still.wet_bounds.size().x(); }

WallReach reach_of(const Scene& scene) {
    const Box& box = scene.domain.box;
    const bool half = scene.hull->half;
    return {half ? box.max.y() : std::min(box.max.y(), -box.min.y()), -box.min.z()};
}

WallEffect effect_at(const Scene& scene, const WallReach& reach) {
    const Hull& hull = *scene.hull;
    const double U = scene.motion.speed, g = scene.water.gravity;
    const double length = wetted_length(hull);
    if (planes(scene)) {
        const double side = of_sides * length * hull.beam * hull.beam / std::pow(reach.side, 3);
        const double floor = of_floor * length * hull.beam / (reach.depth * reach.depth);
        return {(sides_are_meant(scene) ? 0 : side) + (scene.domain.floor_ends_the_box ? floor : 0), "lift"};
    }
    const double froude2 = U * U / (g * reach.depth);
    if (froude2 > largest_depth_froude * largest_depth_froude || !(length > 0)) return {};
    const double m = hull.still.volume / (0.6 * length * 2 * reach.side * reach.depth);
    return m + froude2 < 1 ? WallEffect{2 * m / (1 - m - froude2), "resistance"} : WallEffect{};
}

/// Near the speed of the fastest wave no formula holds, and the walls matter most.
std::string critical_depth_warning(const Scene& scene) {
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream || scene.domain.dimensions != 3 || planes(scene))
        return {};
    const double U = scene.motion.speed, g = scene.water.gravity, depth = reach_of(scene).depth;
    const double froude = U / std::sqrt(g * depth);
    if (froude < largest_depth_froude || froude > 1.2) return {};
    const double enough = std::pow(U / largest_depth_froude, 2) / g;
    return fmt::format(
        "the stream is {:.2f} times as fast as the fastest wave in water {:.3g} m deep: near 1 the walls of the box "
        "change the resistance by more than can be estimated, and the flow may not become steady{}",
        froude, depth,
        scene.domain.floor_ends_the_box ? fmt::format("; a box {:.3g} m deep (below) would suffice", enough) : "");
}

}  // namespace

bool planes(const Scene& scene) { return scene.motion.speed >= std::sqrt(scene.water.gravity * scene.hull->length); }

WallEffect wall_effect(const Scene& scene) {
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream || scene.domain.dimensions != 3) return {};
    if (sides_are_meant(scene) && !scene.domain.floor_ends_the_box) return {};
    return effect_at(scene, reach_of(scene));
}

WallReach reach_for_lift(const Hull& hull, double change) {
    const double length = wetted_length(hull);
    return {std::cbrt(of_sides * length * hull.beam * hull.beam / (change / 2)),
            std::sqrt(of_floor * length * hull.beam / (change / 2))};
}

bool sides_are_meant(const Scene& scene) {
    return scene.hull && scene.motion.kind == Motion::Kind::stream && scene.domain.dimensions == 3 &&
           scene.zones.sides == "walls";
}

std::string channel_text(const Scene& scene) {
    if (!sides_are_meant(scene)) return {};
    const WallReach here = reach_of(scene);
    return scene.domain.floor_ends_the_box
               ? fmt::format(
                     "a channel of this width ({:.3g} m to each side; its floor only ends the box, unless "
                     "[water] depth says that it is the bed)",
                     here.side)
               : fmt::format("a channel of this size ({:.3g} m to each side, {:.3g} m deep)", here.side, here.depth);
}

std::string wall_warning(const Scene& scene) {
    const WallEffect effect = wall_effect(scene);
    if (effect.of.empty()) return critical_depth_warning(scene);
    if (effect.change <= noticed_wall_effect) return {};
    const WallReach here = reach_of(scene);
    const bool wider = !sides_are_meant(scene), deeper = scene.domain.floor_ends_the_box;
    WallReach wide = here;
    const WallEffect* left = &effect;
    WallEffect now;
    for (int k = 0; k < 60 && left->change > noticed_wall_effect; ++k) {
        if (wider) wide.side *= 1.05;
        if (deeper) wide.depth *= 1.05;
        now = effect_at(scene, wide);
        if (now.of.empty()) break;
        left = &now;
    }
    const std::string now_is =
        wider ? fmt::format("walls of the box ({:.3g} m to the side, {:.3g} m deep) are", here.side, here.depth)
              : fmt::format("floor of the box ({:.3g} m deep) is", here.depth);
    std::string enough = wider ? fmt::format("{:.2g} m to the side", wide.side) : "";
    if (deeper) enough += fmt::format("{}{:.2g} m deep", wider ? " and " : "", wide.depth);
    return fmt::format("the {} expected to raise the {} by {:.0f} %; {} would leave {:.0f} %{}", now_is, effect.of,
                       100 * effect.change, enough, 100 * left->change,
                       wider ? "; where they are those of a channel, [domain] sides = \"walls\" says so" : "");
}

}  // namespace tw
