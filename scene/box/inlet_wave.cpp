#include "scene/box/inlet_wave.h"

namespace tw {

bool may_enter_with_stream(const Scene& scene) {
    return scene.motion.kind == Motion::Kind::stream && scene.wave && scene.wave->sum.direction == 1 &&
           scene.motion.speed >= scene.wave->speed_in_water;
}

std::optional<InletWave> inlet_wave(const Scene& scene) {
    const Domain& d = scene.domain;
    if (!may_enter_with_stream(scene) || d.box.min.x() < d.undamped.min.x()) return {};
    return InletWave{.begin = scene.motion.ramp, .ramp = scene.wave->encounter_period()};
}

}  // namespace tw
