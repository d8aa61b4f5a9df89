#pragma once
#include <span>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// A piece of water as a run leaves it: a particle, or the water of one cell.
struct WaterElement {
    Vec3 place = Vec3::Zero();     ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double volume = 0;             ///< of its water [m3]
    double size = 0;               ///< particle spacing, or cube root of the cell's volume [m]
};

/// Which elements hang together: two are linked where they are no farther apart than `link` times the mean of their
/// sizes; a component is what links connect. Components are numbered by falling volume: 0 is the body of water.
/// Returns the number of each element. Throws InputError: `link` not above 0, an element that is not finite or whose
/// size is not above 0.
std::vector<int> components(std::span<const WaterElement> elements, double link);

}  // namespace tw
