#include "statistics/time_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"

namespace tw {

std::vector<double> time_bins(std::span<const double> t, std::span<const double> x, std::size_t count) {
    const std::size_t n = t.size();
    const double span = t[n - 1] - t[0];
    if (count == n) {
        const double step = span / static_cast<double>(n - 1);
        bool even = true;
        for (std::size_t i = 0; i < n && even; ++i)
            even = std::abs(t[i] - t[0] - static_cast<double>(i) * step) < 1e-3 * step;
        if (even) return {x.begin(), x.end()};
    }
    // Integral of the piecewise linear series from t[0] up to any time, walked once.
    std::vector<double> bins(count);
    std::size_t i = 0;
    double whole = 0, before = 0;  // whole: integral up to t[i]
    for (std::size_t b = 0; b < count; ++b) {
        const double end = t[0] + span * static_cast<double>(b + 1) / static_cast<double>(count);
        while (i + 2 < n && t[i + 1] <= end) {
            whole += 0.5 * (x[i] + x[i + 1]) * (t[i + 1] - t[i]);
            ++i;
        }
        const double step = t[i + 1] - t[i], part = std::clamp(end - t[i], 0.0, step);
        const double up_to = whole + (step > 0 ? part * (x[i] + 0.5 * (x[i + 1] - x[i]) * part / step) : 0.0);
        bins[b] = (up_to - before) / (span / static_cast<double>(count));
        before = up_to;
    }
    return bins;
}

double value_at(std::span<const double> t, std::span<const double> x, double at) {
    if (t.empty() || !(at >= t.front()) || at > t.back()) return nan;
    const auto after = static_cast<std::size_t>(std::ranges::lower_bound(t, at) - t.begin());
    if (t[after] == at) return x[after];
    const double w = (at - t[after - 1]) / (t[after] - t[after - 1]);
    return (1 - w) * x[after - 1] + w * x[after];
}

double time_integral(std::span<const double> t, std::span<const double> x) {
    double sum = t.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : 0;
    for (std::size_t i = 1; i < t.size(); ++i) sum += (t[i] - t[i - 1]) * (x[i] + x[i - 1]) / 2;
    return sum;
}

std::vector<double> moving_mean(std::span<const double> t, std::span<const double> x, double width) {
    std::vector<double> smooth(x.size(), std::numeric_limits<double>::quiet_NaN());
    double sum = 0;
    std::size_t first = 0, last = 0, finite = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (; last < x.size() && t[last] <= t[i] + 0.5 * width; ++last)
            if (std::isfinite(x[last])) sum += x[last], ++finite;
        for (; t[first] < t[i] - 0.5 * width; ++first)
            if (std::isfinite(x[first])) sum -= x[first], --finite;
        if (finite > 0) smooth[i] = sum / static_cast<double>(finite);
    }
    return smooth;
}

}  // namespace tw
