#pragma once
#include <cstddef>
#include <optional>
#include <span>

namespace tw {

/// Samples to drop from the start of a series so that the rest is settled, by the marginal standard error rule MSER-5
/// (White 1997): with batch means b_j of 5 samples each,
///
///   d* = argmin_d  sum_{j > d} (b_j - mean_{j > d} b)^2 / (m - d)^2        cut = 5 d*
///
/// over d that leave at least a fifth of the batches. Nothing when d* > m / 2: the series is still settling. Series
/// shorter than 250 samples use batches of one: among few batches the smallest score is a matter of chance.
/// `resolution`: error of a single value [unit of x]; its square is added to the variance, so that a run of equal
/// values in a coarsely resolved series is not taken for the settled part.
std::optional<std::size_t> mser_cut(std::span<const double> x, double resolution = 0);

}  // namespace tw
