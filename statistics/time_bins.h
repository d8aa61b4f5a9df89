#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace tw {

/// Means of a piecewise linear series over `count` equal bins of its whole time span. Time steps may vary: a solver's
/// short steps do not count more than its long ones, and the mean of the bins is the time mean. `t` increases; at least
/// two points. When the series has as many points as bins and equal steps, the bins are the samples themselves.
std::vector<double> time_bins(std::span<const double> t, std::span<const double> x, std::size_t count);

/// Value of a series at time `at` by linear interpolation; NaN outside its span or where a neighbour is not finite.
double value_at(std::span<const double> t, std::span<const double> x, double at);

/// Integral of a piecewise linear series over its time span, as of an impulse of a force; NaN where a value is missing
/// (an integral over a gap is none) and with fewer than two.
double time_integral(std::span<const double> t, std::span<const double> x);

/// Moving mean over a window of `width` [s], for display only; NaN values are left out.
std::vector<double> moving_mean(std::span<const double> t, std::span<const double> x, double width);

}  // namespace tw
