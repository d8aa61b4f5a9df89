#include "compare/statistics/batch_means.h"

#include <cmath>
#include <numeric>

namespace tw {

double batch_means_error(std::span<const double> x, std::size_t b) {
    const std::size_t n = x.size();
    if (b < 1 || 2 * b > n) return 0;
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(n);
    double batch = std::accumulate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(b), 0.0), squares = 0;
    for (std::size_t j = 0;; ++j) {
        const double deviation = batch / static_cast<double>(b) - mean;
        squares += deviation * deviation;
        if (j + b >= n) break;
        batch += x[j + b] - x[j];
    }
    return std::sqrt(static_cast<double>(b) / (static_cast<double>(n - b + 1) * static_cast<double>(n - b)) * squares);
}

}  // namespace tw
