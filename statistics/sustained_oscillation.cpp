#include "statistics/sustained_oscillation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace tw {
namespace {

constexpr std::size_t fewest_cycles = 4;
constexpr double most_irregular = 0.25, least_sustained = 0.7, dead_band = 1.0 / 3;

double mean(std::span<const double> v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}
double deviation(std::span<const double> v) {
    const double middle = mean(v);
    double squares = 0;
    for (const double x : v) squares += (x - middle) * (x - middle);
    return std::sqrt(squares / static_cast<double>(v.size()));
}

struct Series {
    std::vector<double> time, value;
};

/// The known values from `from` on, less their least-squares straight line.
Series without_trend(std::span<const double> time, std::span<const double> values, double from) {
    Series s;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= from && std::isfinite(values[i])) s.time.push_back(time[i]), s.value.push_back(values[i]);
    if (s.time.size() < 2) return {};
    const double middle = mean(s.time), height = mean(s.value);
    double tt = 0, tv = 0;
    for (std::size_t i = 0; i < s.time.size(); ++i) {
        tt += (s.time[i] - middle) * (s.time[i] - middle);
        tv += (s.time[i] - middle) * (s.value[i] - height);
    }
    const double slope = tt > 0 ? tv / tt : 0;
    for (std::size_t i = 0; i < s.time.size(); ++i) s.value[i] -= height + slope * (s.time[i] - middle);
    return s;
}

/// First rows after upward crossings of zero that lead from below -band to above band.
std::vector<std::size_t> crossings(const std::vector<double>& value, double band) {
    std::vector<std::size_t> rows;
    bool was_low = false;
    std::size_t last_rise = 0;
    for (std::size_t i = 1; i < value.size(); ++i) {
        if (value[i] < -band) was_low = true;
        if (value[i - 1] < 0 && value[i] >= 0) last_rise = i;
        if (was_low && value[i] > band) rows.push_back(last_rise), was_low = false;
    }
    return rows;
}

}  // namespace

std::optional<Oscillation> sustained_oscillation(std::span<const double> time, std::span<const double> values,
                                                 double from) {
    const Series s = without_trend(time, values, from);
    if (s.time.empty()) return {};
    const std::vector<std::size_t> starts = crossings(s.value, dead_band * deviation(s.value));
    if (starts.size() < fewest_cycles + 1) return {};
    std::vector<double> periods, amplitudes;
    for (std::size_t k = 1; k < starts.size(); ++k) {
        periods.push_back(s.time[starts[k]] - s.time[starts[k - 1]]);
        const auto [low, high] =
            std::ranges::minmax(std::span(s.value).subspan(starts[k - 1], starts[k] - starts[k - 1]));
        amplitudes.push_back((high - low) / 2);
    }
    if (deviation(periods) > most_irregular * mean(periods)) return {};
    const std::size_t half = amplitudes.size() / 2;
    const std::span<const double> all(amplitudes);
    if (mean(all.last(half)) < least_sustained * mean(all.first(half))) return {};
    return Oscillation{mean(periods), mean(amplitudes), static_cast<int>(periods.size())};
}

}  // namespace tw
