#pragma once
#include "scene/scene.h"

namespace tw {

/// Whether water that falls from rest in a tank strikes an elastic plate that is held and stands dry at the start. The
/// plate bends, and throws the water as a sheet against what is behind: an impact, whose jets run at four to five times
/// the speed of the fall (docs/stability.md), where water that a plate has held from the start only pours.
bool water_strikes_plate(const Scene& scene);

}  // namespace tw
