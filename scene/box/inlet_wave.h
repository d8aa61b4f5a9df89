#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

/// When a wave that enters with the stream begins at the inlet, and grows to its height.
struct InletWave {
    double begin = 0;  ///< the stream has its speed then [s]
    double ramp = 0;   ///< [s]: one period of encounter, of a sum that of the longest wave that counts
};

/// A head wave in a stream at least as fast as it needs no zone: nothing runs upstream (U omega_e/g is 2 and
/// more in deep water, waves that a hull makes stay behind it from 1/4 on), so the water that enters may have the
/// wave's velocity, level and pressure, and the outlet lets it go. Empty where zones lie outside the box, which then
/// make the wave (scene/box/forcing_zones.h): with the effect `forcing_zones` on. Of a scene whose domain is known.
///
/// Of a sum the stream is at least as fast as the longest wave that counts (tank_wave.h). Those that are longer still,
/// with 5 % of the energy at most, enter like the others: the longest of a spectrum, of half the peak's frequency, runs in deep
/// water less than twice as fast as the longest that counts, so that its U omega_e/g is above 3/4.
///
/// The share of its height at time t is smooth: 0 before `begin`, 1 from `begin + ramp` on, s^2 (3 - 2 s) between.
std::optional<InletWave> inlet_wave(const Scene& scene);

/// Whether it could, were there no zones. Of a scene whose wave is known.
bool may_enter_with_stream(const Scene& scene);
double fastest_that_counts(
    const Scene& scene);  ///< speed in the water of the wave, or of a sum's longest that counts [m/s]
double time_to_grow_at_inlet(const Scene& scene);  ///< [s]

}  // namespace tw
