#pragma once
#include <cmath>

namespace tw {

// Time steps of interFoam that follow from gravity and the edge of its finest cells, for the case and for its
// prediction.

/// The longest: gravity acts explicitly on the surface, and still water would otherwise be taken in steps that shake it
/// [s].
inline double longest_step_of_still_water(double cell, double gravity) { return 0.5 * std::sqrt(cell / gravity); }

/// The first of a body that is let go at rest: a fiftieth of the time in which it falls through a cell [s]. A wall that
/// moves gives the water its speed of half a step ago (docs/decisions/032-rigid-bodies.md).
inline constexpr double steps_of_release = 50;
inline double release_step(double cell, double gravity) { return std::sqrt(2 * cell / gravity) / steps_of_release; }

}  // namespace tw
