#pragma once
#include "scene/scene.h"

namespace tw {

/// Share of a tank's floor on which no water stands at the start [-]: over it the water's front will run.
double dry_floor(const Scene& scene);

/// The height of water that is let go at the start [m]: of the highest block over the floor, where the blocks are not
/// level (running_water.h); 0 where the water stays as it is put.
double released_height(const Scene& scene);

}  // namespace tw
