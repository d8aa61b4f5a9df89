#pragma once
#include "compare/compare.h"
#include "compare/metrics/wave_periods.h"

namespace tw {

/// Amplitude, phase and mean of the force of a regular wave on what stands fixed in its tank (regular_wave.h).
void add_wave_forces(Comparison& comparison, const WavePeriods& periods);

}  // namespace tw
