#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// A number read off one column x(t) of a record's table between two times, for truths that no quantity of a report
/// stands for:
///
///   mean       time mean, linear between the samples
///   at         the value at a time
///   largest, smallest
///   crossing   the first time at which x is above `threshold` [s]
///   period     2 pi / omega of the omega at which |int w (x - mean) exp(-i omega t) dt| is largest, w: Hann's window
///              [s]; Harris, Proc. IEEE 66 (1978) 51: side lobes fall with the third power, so that a second wave of other
///              frequency does not shift it once a few periods are recorded
struct Reading {
    enum class Kind { mean, at, largest, smallest, crossing, period };
    std::string table, column;
    Kind kind = Kind::mean;
    double from = -infinite, to = infinite;  ///< [s]
    double at = nan;                         ///< [s]
    double threshold = nan;                  ///< [the column's unit]
};
/// The names of the kinds, in their order.
const std::vector<std::string>& reading_kinds();

/// That number of a run as a quantity that a grid study judges; where the record does not give it, its only value says
/// why.
Quantity quantity_of(const Reading& reading, const std::string& name, const std::string& label,
                     const RunRecord& record);

}  // namespace tw
