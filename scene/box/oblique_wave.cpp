#include "scene/box/oblique_wave.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tw {
namespace {

constexpr double strength_of_oblique = 1.5;  ///< over that of a zone of one wave length that absorbs the wave
constexpr double least_frequency = 0.5;      ///< for which zones are made, of omega

double omega_in_water(const RegularWave& wave) { return wave.k() * wave.speed_in_water; }

/// In place of omega_e, for the zones at the ends of an axis [rad/s].
double frequency_across(const RegularWave& wave, int axis) {
    const double omega = omega_in_water(wave), U = wave.sum.current, along = wave.sum.direction;
    const double across = axis == 1    ? omega * std::abs(wave.sum.across)
                          : along >= 0 ? wave.k() * (wave.speed_in_water * along + U)
                                       : omega * std::abs(U / wave.group_speed_in_water() + along);
    return std::max(across, least_frequency * omega);
}

}  // namespace

bool runs_obliquely(const Scene& scene) { return scene.wave && scene.wave->sum.across != 0; }

Eigen::Vector2d energy_velocity(const Scene& scene) {
    const RegularWave& wave = *scene.wave;
    const double group = wave.group_speed_in_water();
    return {wave.sum.current + group * wave.sum.direction, group * wave.sum.across};
}

double time_to_fill(const Scene& scene) {
    const Eigen::Vector2d V = energy_velocity(scene);
    double time = INFINITY;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = V[axis] > 0 ? scene.domain.undamped.max[axis] - scene.domain.box.min[axis]
                                       : scene.domain.box.max[axis] - scene.domain.undamped.min[axis];
        if (V[axis] != 0) time = std::min(time, way / std::abs(V[axis]));
    }
    return time;
}

void take_oblique_wave(const Scene& scene, ForcingZones& plan) {
    const RegularWave& wave = *scene.wave;
    plan.wave_length = wave.length;
    plan.frequency = std::abs(wave.encounter_frequency());
    double least = INFINITY;
    for (ForcingZone& zone : plan.zones) {
        zone.makes_wave = true;
        zone.gamma =
            strength_of_oblique * 1.5 * frequency_across(wave, zone.axis) / std::sqrt(std::tanh(wave.k() * wave.depth));
        least = std::min(least, std::abs(zone.end - zone.begin) / wave.length);
    }
    plan.why =
        fmt::format("all of them draw to stream and wave, over {:.3g} of its lengths and more; {}", least, plan.why);
}

}  // namespace tw
