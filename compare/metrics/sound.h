#pragma once
#include <span>
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

// Sound in the answer of a weakly compressible method. Where water meets a wall with a blunt front of particles, the wall
// sees rho c0 v until sound has crossed that front and come back: a pulse whose height grows with the sound speed and
// whose length, a few dp/c0, falls with it. Its impulse is that of the front, which the spacing makes blunt, and no
// property of the flow. Measured on a dam break with c0, 1.5 c0 and 2 c0: 101, 153 and 166 kPa, 2.9, 3.2 and 3.1 dp/c0
// long (docs/decisions/023-trend-and-noise.md). A peak of the flow lasts longer.

/// What is shorter than this is sound [s]: the time in which it crosses six particles, 6 dp / c0, twice the length of the
/// measured pulses. 0: the record's method has no sound.
double sound_time(const RunRecord& record);

/// What of a history lasts at least `shortest` [s]: at each sample the largest level that a stretch of that length about
/// it stays above (its opening; Serra 1982). Never above the history; samples that are not finite end a stretch.
std::vector<double> lasting(std::span<const double> t, std::span<const double> x, double shortest);

/// A value that is sound is told by what is left of it: the same value of the lasting history is less than this share.
/// Between what was found of blunt fronts (0.23 to 0.58) and of flows (0.89 to 1: cylinders that enter water, sloshing).
inline constexpr double least_lasting = 2.0 / 3;

/// "sound of the impact: ...": why a peak is not judged, of which `lasts` is left where what is shorter than `shortest`
/// is taken away; empty: it is no sound.
std::string why_sound(double peak, double lasts, double shortest, const std::string& unit);
/// Says so of a quantity's value of one source, called `name`, that is sound, and leaves others alone.
void set_sound_aside(Quantity& quantity, std::size_t source, double lasts, double shortest, const std::string& name);

}  // namespace tw
