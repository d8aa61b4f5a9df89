#pragma once
#include <span>
#include <string>

#include "compare/compare.h"

namespace tw {

/// Of bodies that oscillate freely in still water (no wave, no stream) and come to rest, from their records: period and
/// damping of each motion that swings to and fro three times and more,
///   heave_period:BODY, pitch_period:BODY, roll_period:BODY     of the damped motion [s]
///   heave_damping:BODY, pitch_damping:BODY, roll_damping:BODY  share of the critical damping, delta / sqrt(delta^2 +
///                                                              omega^2) [-]
/// by free_decay, with their 95 % intervals.
void add_free_decay(Comparison& comparison);

/// x(t) = level + A exp(-delta t) cos(omega t + phase), by least squares over the samples from the first extreme after
/// the release on. Period and damping are those of the fit; their intervals are from how far the half swings between
/// successive extremes differ, which holds what a single exponential leaves out (waves that come back, memory of the
/// water, damping by the square of the speed). Where it does not apply `why_not` says why.
struct FreeDecay {
    MeanValue period, damping;  ///< [s], [-]
    double level = 0;           ///< about which it swings [unit of the series]
    int half_swings = 0;
    std::string why_not = {};
};
FreeDecay free_decay(std::span<const double> t, std::span<const double> x, double smallest);

}  // namespace tw
