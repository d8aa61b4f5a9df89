#include "statistics/peak_statistics.h"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace tw {
namespace {

constexpr double certainty = 0.95;

std::vector<double> ordered(std::span<const double> peaks) {
    std::vector<double> x(peaks.begin(), peaks.end());
    std::ranges::sort(x);
    return x;
}

/// At the place `at` of ordered values, the first being 1; linear between two.
double value_at_rank(const std::vector<double>& x, double at) {
    const double place = std::clamp(at, 1.0, static_cast<double>(x.size())) - 1;
    const auto below = std::min(static_cast<std::size_t>(place), x.size() - 1),
               above = std::min(below + 1, x.size() - 1);
    return x[below] + (place - static_cast<double>(below)) * (x[above] - x[below]);
}

/// Of ordered values, highest first.
double mean_of_third(const std::vector<double>& x) {
    const auto third = static_cast<std::ptrdiff_t>(x.size() / 3);
    return std::accumulate(x.begin(), x.begin() + third, 0.0) / static_cast<double>(third);
}

/// splitmix64, the same on every machine.
std::uint64_t next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

}  // namespace

double PeakValue::half_width() const { return std::max(high - value, value - low); }

std::optional<PeakValue> quantile_of_peaks(std::span<const double> peaks, double p) {
    const auto n = peaks.size();
    if (static_cast<int>(n) < fewest_peaks_for(p)) return {};
    const boost::math::binomial_distribution<double> below(static_cast<double>(n), p);
    std::vector<double> up_to(n);  // probability that at most k peaks are below the quantile
    for (std::size_t k = 0; k < n; ++k) up_to[k] = cdf(below, static_cast<double>(k));
    std::size_t low = 1, high = n;
    for (std::size_t l = 1; l < n; ++l) {
        std::size_t u = l + 1;
        while (u < n && up_to[u - 1] - up_to[l - 1] < certainty) ++u;
        if (up_to[u - 1] - up_to[l - 1] >= certainty && u - l < high - low) low = l, high = u;
    }
    const std::vector<double> x = ordered(peaks);
    return PeakValue{value_at_rank(x, (static_cast<double>(n) + 1.0 / 3) * p + 1.0 / 3), x[low - 1], x[high - 1]};
}

int fewest_peaks_for(double p) {
    int n = 1;
    while (1 - std::pow(p, n) - std::pow(1 - p, n) < certainty) ++n;
    return n;
}

std::optional<PeakValue> highest_third(std::span<const double> peaks) {
    if (static_cast<int>(peaks.size()) < fewest_peaks_for_third) return {};
    constexpr int drawn = 2000;
    std::vector<double> x(peaks.begin(), peaks.end()), means;
    std::ranges::sort(x, std::greater());
    std::uint64_t state = 1;
    std::vector<double> sample(x.size());
    for (int i = 0; i < drawn; ++i) {
        for (double& value : sample) value = x[next(state) % x.size()];
        std::ranges::sort(sample, std::greater());
        means.push_back(mean_of_third(sample));
    }
    std::ranges::sort(means);
    const double end = (1 - certainty) / 2;
    return PeakValue{mean_of_third(x), value_at_rank(means, end * drawn), value_at_rank(means, (1 - end) * drawn)};
}

PeakValue count_of_events(int events, int periods) {
    using Binomial = boost::math::binomial_distribution<double>;
    const double n = periods, k = events, end = (1 - certainty) / 2;
    return {k, events == 0 ? 0 : n * Binomial::find_lower_bound_on_p(n, k, end),
            events == periods ? n : n * Binomial::find_upper_bound_on_p(n, k, end)};
}

}  // namespace tw
