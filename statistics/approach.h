#pragma once
#include <span>

namespace tw {

/// What a slow approach to a limit may still lack in a mean. To a series, in equal time bins, is fitted
///
///   x(t) = x_inf + B exp(-(t - t_0)/theta) + e        least squares in x_inf and B, theta the best of a row
///
/// with t_0 the first time and theta from a fiftieth of the series' length to all of it, each 1.5 times the one before.
/// The mean over [from, end] then lacks B m of its limit, m the mean of the exponential there; its standard error is
/// m s sqrt(2 tau_int / sum (f - mean f)^2) with s and the autocorrelation time of e. A transient that a test of the
/// trend in the window alone does not tell from noise is seen here, because the fit sees the series before the window
/// too.
struct Approach {
    double lacking = 0;  ///< |B| m [unit of the series]
    double error = 0;    ///< standard error of it [unit of the series]
};
/// `time` increases and has ten points or more; `from`: where the mean's window begins [s].
Approach approach_of(std::span<const double> time, std::span<const double> values, double from);

}  // namespace tw
