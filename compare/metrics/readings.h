#pragma once
#include <span>

#include "compare/compare.h"

namespace tw {

// What reading a number off a history leaves open, whatever the resolution's own error (MeanValue::reading_below).

/// How far below and above the value the truth may lie [unit].
struct Reading {
    double below = 0, above = 0;
};

/// Half of the time in which water that falls from the height at which it is let go, sqrt(2 g H), crosses one spacing or
/// cell at the hull [s]: no place is finer. 0 where none is let go.
double half_a_spacing_in_time(const RunRecord& record);

/// Of an arrival [s]: to either side root of the sum of squares of the time from half the threshold on, or to twice the
/// threshold (where water comes slowly it has no sharper arrival), of half a spacing and of half the time between samples.
Reading reading_of_arrival(std::span<const double> t, std::span<const double> x, double first, double peak,
                           const RunRecord& record);

/// Of a level [m]: half a spacing; none stands finer.
Reading reading_of_height(const RunRecord& record);

/// Puts it into a value that is known, with what it is.
void set_reading(MeanValue& value, const Reading& reading, const char* of);
inline constexpr const char* of_arrival = "the reading (threshold, spacing, sampling)";
inline constexpr const char* of_height = "the reading (half a spacing)";

}  // namespace tw
