#include "scene/box/inlet_wave.h"

#include <numbers>

#include "scene/box/tank_wave.h"

namespace tw {

double fastest_that_counts(const Scene& scene) {
    if (scene.wave) return scene.wave->speed_in_water;
    const WaveComponents& waves = scene.sea->waves;
    const int low = scene.sea->component_at(waves_that_count);
    return waves.omega[low] / waves.k[low];
}

bool may_enter_with_stream(const Scene& scene) {
    if (scene.motion.kind != Motion::Kind::stream || !scene.has_wave()) return false;
    const double direction = scene.wave ? scene.wave->sum.direction : scene.sea->waves.direction;
    return direction == 1 && scene.motion.speed >= fastest_that_counts(scene);
}

double time_to_grow_at_inlet(const Scene& scene) { return 2 * std::numbers::pi / wave_scales(scene).lowest_frequency; }

std::optional<InletWave> inlet_wave(const Scene& scene) {
    const Domain& d = scene.domain;
    if (!may_enter_with_stream(scene) || d.box.min.x() < d.undamped.min.x()) return {};
    return InletWave{.begin = scene.motion.ramp, .ramp = time_to_grow_at_inlet(scene)};
}

}  // namespace tw
