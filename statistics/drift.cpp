#include "statistics/drift.h"

#include <limits>
#include <numeric>
#include <vector>

#include "statistics/error_of_mean.h"
#include "statistics/student_t.h"

namespace tw {

Drift drift_of(std::span<const double> x) {
    const auto n = static_cast<double>(x.size());
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n, middle = 0.5 * (n - 1);
    const double ii = n * (n * n - 1) / 12;  // sum of (i - middle)^2
    double ix = 0;
    for (std::size_t i = 0; i < x.size(); ++i) ix += (static_cast<double>(i) - middle) * (x[i] - mean);
    const double b = ix / ii;
    std::vector<double> e(x.size());
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        e[i] = x[i] - mean - b * (static_cast<double>(i) - middle);
        squares += e[i] * e[i];
    }
    Drift d;
    d.change = b * n;
    d.n_effective = n / (2 * integrated_autocorrelation_time(e, 2));
    d.mean_error = std::sqrt(squares / (n - 2) / d.n_effective);
    d.interval = d.n_effective < 3 ? std::numeric_limits<double>::infinity()
                                   : correlated_t_95(d.n_effective, 2) * std::sqrt(12.0) * d.mean_error;
    const double rounding = 1e-12 * std::abs(mean);
    if (std::abs(d.change) < rounding) d.change = 0;
    return d;
}

}  // namespace tw
