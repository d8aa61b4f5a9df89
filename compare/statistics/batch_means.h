#pragma once
#include <cstddef>
#include <span>

namespace tw {

/// Standard error of the mean by overlapping batch means (Meketon & Schmeiser 1984), batches of b samples:
///
///   u^2 = b / ((n - b + 1)(n - b)) sum_j (mean_j - mean)^2
///
/// An estimate independent of the autocorrelation sum. Zero when b does not fit twice.
double batch_means_error(std::span<const double> x, std::size_t b);

}  // namespace tw
