#pragma once
#include "compare/compare.h"

namespace tw {

/// Of records with a sum of waves (attribute `sea`), from their height gauges. Of a spectrum over whole repeat periods of
/// the sea, the last ones that all records cover from mean_from on, else over all of that time:
///   significant_height:GAUGE    4 standard deviations of the level [m]
///   crossing_height:GAUGE       mean of the highest third of the waves between zero up-crossings [m]
///   peak_period:GAUGE           sum E^4 / sum f E^4 over the lines of the spectrum (Young 1995, Ocean Eng. 22, 669) [s]
/// of two waves, over whole beats:
///   first_wave:GAUGE, second_wave:GAUGE   their heights, lower frequency first [m]
/// of a focused wave, within two peak periods of its time:
///   focused_crest:GAUGE [m], focused_crest_time:GAUGE [s]
/// and of all but a focused one
///   wave_reflection             root of reflected over incident energy, line by line, by two gauges or more [%]
/// Linear theory stands beside each as a reference, beside a focused crest second order too.
void add_sea(Comparison& comparison);

}  // namespace tw
