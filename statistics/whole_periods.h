#pragma once
#include <algorithm>
#include <cmath>

namespace tw {

/// How many whole periods [s] lie between two times [s]; one that lacks less than a millionth of itself, by rounding of
/// the times, counts.
inline int whole_periods(double from, double to, double period) {
    return std::max(0, static_cast<int>(std::floor((to - from) / period + 1e-6)));
}

}  // namespace tw
