#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

/// Bounds of the water at rest [m]: depth below the surface of the deepest place, by the domain as it was asked for:
/// what follows from it (sound speed, times) is the same at every resolution.
double water_height(const Scene& scene);
/// Where the water stands at the start, solids in it included; boxes that do not overlap.
std::vector<Box> blocks_of_water(const Scene& scene);
/// Water at the start [m3], of what is solved (half a half model).
double water_volume(const Scene& scene);
/// What water, hull and obstacles leave of the domain [m3].
double air_volume(const Scene& scene);

}  // namespace tw
