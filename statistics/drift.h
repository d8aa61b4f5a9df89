#pragma once
#include <cmath>
#include <span>

namespace tw {

/// The straight line through a series of evenly spaced samples under autocorrelated noise:
///
///   x_i = m + b (i - (n - 1)/2) + e_i       least squares; s^2 = sum e_i^2/(n - 2), n_eff = n/(2 tau_int) of e
///   change = b n                            over the series; standard error sqrt(12/n_eff) s
///   u = s/sqrt(n_eff)                       standard error of the mean, the trend taken off
///
/// (variance of a slope with n_eff independent samples instead of n.)
struct Drift {
    double change = 0;  ///< over the series [unit of x]
    double interval =
        0;  ///< half width of its 95 % interval [unit of the series], correlated_t_95; infinite for n_eff below 3
    double mean_error = 0;   ///< u [unit of x]
    double n_effective = 0;  ///< of the noise [-]

    /// The change is more than noise of that autocorrelation makes in 95 of 100 series without a trend.
    bool seen() const { return std::abs(change) > interval; }
};
/// `x`: three samples or more.
Drift drift_of(std::span<const double> x);

}  // namespace tw
