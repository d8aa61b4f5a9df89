#include "statistics/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "statistics/error_of_mean.h"
#include "statistics/time_bins.h"

namespace tw {

Approach approach_of(std::span<const double> time, std::span<const double> values, double from) {
    constexpr std::size_t most_bins = 256;
    constexpr double shortest = 0.02, ratio = 1.5;
    const std::vector<double> x = time_bins(time, values, std::min(time.size(), most_bins));
    const auto n = static_cast<double>(x.size());
    const double length = time.back() - time.front(), bin = length / n;
    const double a = std::clamp(from - time.front(), 0.0, length - bin);
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    Approach best;
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> f(x.size()), e(x.size());
    for (double theta = length; theta > shortest * length; theta /= ratio) {
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = std::exp(-(static_cast<double>(i) + 0.5) * bin / theta);
        const double f_mean = std::accumulate(f.begin(), f.end(), 0.0) / n;
        double ff = 0, fx = 0, squares = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            ff += (f[i] - f_mean) * (f[i] - f_mean);
            fx += (f[i] - f_mean) * (x[i] - mean);
        }
        const double B = fx / ff;
        for (std::size_t i = 0; i < f.size(); ++i) {
            e[i] = x[i] - mean - B * (f[i] - f_mean);
            squares += e[i] * e[i];
        }
        if (!(squares < least)) continue;
        least = squares;
        const double m = theta * (std::exp(-a / theta) - std::exp(-length / theta)) / (length - a);
        const double tau = integrated_autocorrelation_time(e, 2);
        best = {std::abs(B) * m, m * std::sqrt(squares / (n - 3) * 2 * tau / ff)};
    }
    return best;
}

}  // namespace tw
