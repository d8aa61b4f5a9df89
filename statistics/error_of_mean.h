#pragma once
#include <cstddef>
#include <span>

namespace tw {

// How far the mean of a correlated series is known: by its autocorrelation, and independently of that by the means of
// its parts.

/// Integrated autocorrelation time in samples [-]:
///
///   tau_int = 1/2 + sum_{k=1}^{K} rho(k),   K the first lag with K > 5 tau_int(K)
///
/// (Sokal's self-consistent window), at least 1/2. The mean's variance is s^2 2 tau_int / n, so n_eff = n / (2
/// tau_int). Each parameter that was fitted to the same samples and taken off (the mean: 1; mean and slope: 2) makes
/// rho too low by about 2 tau_int / n; that much is added back.
double integrated_autocorrelation_time(std::span<const double> x, int fitted = 1);

/// Student's 95 % quantile for n_eff independent samples out of a correlated series of which `fitted` parameters were
/// taken [-]. The variance s^2/n_eff of the mean has itself a relative variance of about 2/n_eff, from s^2, and
/// 2 (2K + 1)/n = 10/n_eff, from tau_int with Sokal's window K = 5 tau_int; that of chi-square with nu degrees of
/// freedom is 2/nu, so nu = (n_eff - fitted)/6.
double correlated_t_95(double n_eff, int fitted);

/// Half width of the 95 % interval of the mean of a stationary series, from evenly spaced samples [unit of x]:
/// Student's quantile times s/sqrt(n_eff); no wider than 2 s, where the samples themselves lie. 0 with fewer than two.
double half_width_of_mean(std::span<const double> x);

/// Standard error of the mean by overlapping batch means (Meketon & Schmeiser 1984), batches of b samples:
///
///   u^2 = b / ((n - b + 1)(n - b)) sum_j (mean_j - mean)^2
///
/// An estimate independent of the autocorrelation sum. Zero when b does not fit twice.
double batch_means_error(std::span<const double> x, std::size_t b);

}  // namespace tw
