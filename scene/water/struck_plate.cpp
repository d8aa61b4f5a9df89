#include "scene/water/struck_plate.h"

#include <algorithm>

#include "base/gap.h"
#include "scene/water/running_water.h"

namespace tw {

bool water_strikes_plate(const Scene& scene) {
    const auto is_dry = [&](const MovingBody& body) {
        const Box at = body.surface.bounds();
        return std::ranges::none_of(
            scene.water_blocks, [&](const Box& block) { return gap_of_boxes(at, block) < scene.resolution.near_hull; });
    };
    const auto is_held = [](const MovingBody& body) { return body.plate() && body.motion.law; };
    return std::ranges::any_of(scene.bodies, [&](const MovingBody& b) { return is_held(b) && is_dry(b); }) &&
           running_water(scene);
}

}  // namespace tw
