#pragma once
#include <span>

namespace tw {

/// Integrated autocorrelation time in samples [-]:
///
///   tau_int = 1/2 + sum_{k=1}^{K} rho(k),   K the first lag with K > 5 tau_int(K)
///
/// (Sokal's self-consistent window), at least 1/2. The mean's variance is s^2 2 tau_int / n, so n_eff = n / (2
/// tau_int). Since the mean is estimated from the same samples, rho is too low by about 2 tau_int / n; that much is
/// added back.
double integrated_autocorrelation_time(std::span<const double> x);

}  // namespace tw
