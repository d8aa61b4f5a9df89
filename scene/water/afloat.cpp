#include "scene/water/afloat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/gap.h"
#include "scene/water/water_blocks.h"

namespace tw {
namespace {

bool floats(const Surface& surface, const RigidBodySetup& motion, const Scene& scene) {
    if (motion.law) return false;
    const Box at = surface.bounds();
    const double volume = mass_properties(surface).volume, mass = motion.mass.mass;  // in two dimensions per metre
    const double slow = 0.1 * std::sqrt(scene.water.gravity * at.size().z());
    return mass < scene.water.density * volume && motion.velocity.norm() < slow &&
           std::ranges::any_of(blocks_of_water(scene), [&](const Box& water) {
               Box there = water;
               if (scene.domain.dimensions == 2) there.min.y() = at.min.y(), there.max.y() = at.max.y();
               return gap_of_boxes(at, there) < 0;
           });
}

}  // namespace

bool carries_a_body(const Scene& scene) {
    if (scene.motion.kind == Motion::Kind::stream || !(scene.water.gravity > 0)) return false;
    if (scene.hull_is_free() && floats(scene.hull->surface, scene.hull->free->motion, scene)) return true;
    return std::ranges::any_of(scene.bodies,
                               [&](const MovingBody& b) { return !b.elastic && floats(b.surface, b.motion, scene); });
}

std::string why_one_size_afloat(const Scene& scene) {
    if (scene.sph.levels > 1 || scene.places.contains("sph.levels") ||
        !(scene.resolution.spacing > scene.resolution.near_hull) || scene.tank_motion || !carries_a_body(scene))
        return {};
    return fmt::format(
        "particles have one size, {:.4g} m: beside a body afloat in water at rest coarser ones would accumulate under "
        "the zone of the finer ones (6 % of its mass in 2 s) and the body would sink; [sph] levels overrides this",
        scene.resolution.near_hull);
}

}  // namespace tw
