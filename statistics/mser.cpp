#include "statistics/mser.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tw {

std::optional<std::size_t> mser_cut(std::span<const double> x, double resolution) {
    const std::size_t batch = x.size() < 250 ? 1 : 5;
    const std::size_t m = x.size() / batch;
    if (m < 4) return std::nullopt;
    std::vector<double> b(m, 0.0);
    for (std::size_t j = 0; j < m; ++j) {
        for (std::size_t i = 0; i < batch; ++i) b[j] += x[j * batch + i];
        b[j] /= static_cast<double>(batch);
    }
    // From the back, so that each d needs one more batch: Welford's update of mean and sum of squares.
    double mean = 0, squares = 0, best = std::numeric_limits<double>::infinity();
    std::size_t best_d = m;
    const std::size_t fewest = std::max<std::size_t>(3, m / 5);  // a few batches agree with each other by chance
    for (std::size_t d = m; d-- > 0;) {
        const double n = static_cast<double>(m - d);
        const double step = b[d] - mean;
        mean += step / n;
        squares += step * (b[d] - mean);
        if (m - d < fewest) continue;
        const double score = (squares / n + resolution * resolution) / n;
        if (score <= best) {
            best = score;
            best_d = d;
        }
    }
    if (2 * best_d > m) return std::nullopt;
    return best_d * batch;
}

}  // namespace tw
