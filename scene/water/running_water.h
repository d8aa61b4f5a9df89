#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

/// How high above the z axis' origin the water of a tank comes to stand over a zone of finer particles, where its
/// blocks will run: they do not fill the tank to one level at the start.
///
///   level    all the water at rest [m]: what a zone holds in the mean over a run that is long beside the water's way
///   highest  at most [m]: twice as far above the floor as `level`, and no higher than the highest block's top
///
/// Twice, because water that sways to one end and just lays the other dry stands on a slope with twice its level at
/// that end, and less over any zone; water that falls from rest does not rise above where it fell from. Against two runs
/// of SPHERIC's dam break: tests/unit/scene/running_water_test.cpp. A jet up a wall is above it, but holds little. A run
/// that ends before the water has come takes less, and the walls between separate basins of a tank are not seen.
struct RunningWater {
    double level = 0, highest = 0;
};
/// Nothing in a stream, without gravity, and where the water is level to half the finest particle.
std::optional<RunningWater> running_water(const Scene& scene);

/// Of hull, obstacles and bodies at the start what lies below `z` [m3].
double solids_below(const Scene& scene, double z);

}  // namespace tw
