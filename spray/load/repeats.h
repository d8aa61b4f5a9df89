#pragma once
#include <span>
#include <vector>

namespace tw::spray {

/// Repeats of one measurement, and what Pauta's criterion leaves of them: values farther than three standard deviations
/// from the mean of all are left out. Of n values none is farther than (n - 1) / sqrt(n) of them, so with ten or fewer
/// nothing can be.
struct Repeats {
    std::vector<double> values;
    double mean = 0, deviation = 0;  ///< of all; deviation with n - 1
    double farthest = 0;             ///< of them, in standard deviations from the mean
    std::size_t left_out = 0;
    double kept_mean = 0;
    double error = 0;  ///< standard error of the kept mean
};
/// Throws InputError: fewer than two values, or one that is not finite.
Repeats repeats_of(std::span<const double> values);

}  // namespace tw::spray
