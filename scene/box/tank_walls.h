#pragma once
#include "scene/scene.h"

namespace tw {

/// Whether the water sticks to the floor and the sides of the box: in a tank with the effect no_slip. The sides and the
/// floor of a stream's box are where the solved water ends, so they let it slip, and symmetry planes always do.
inline bool tank_holds_water(const Scene& scene) {
    return scene.motion.kind == Motion::Kind::none && scene.effect_on("no_slip");
}

}  // namespace tw
