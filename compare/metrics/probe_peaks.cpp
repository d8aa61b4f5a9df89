#include "compare/metrics/probes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

/// Largest mean over windows inside one stretch of finite samples. The mean of a window that slides over a piecewise
/// linear history is largest where the window begins or ends on a sample, or between two such places where both ends
/// have one height; the first suffices within the error of the linear history itself.
double largest_in_stretch(std::span<const double> t, std::span<const double> x, double width) {
    std::vector<double> integral(t.size(), 0.0);
    for (std::size_t i = 1; i < t.size(); ++i)
        integral[i] = integral[i - 1] + (t[i] - t[i - 1]) * (x[i] + x[i - 1]) / 2;
    const auto until = [&](double time) {
        const auto after = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(t, time) - t.begin(), 1,
                                                      static_cast<std::ptrdiff_t>(t.size()) - 1);
        const auto k = static_cast<std::size_t>(after);
        const double part = (time - t[k - 1]) / (t[k] - t[k - 1]), there = x[k - 1] + part * (x[k] - x[k - 1]);
        return integral[k - 1] + (time - t[k - 1]) * (x[k - 1] + there) / 2;
    };
    double most = nan;
    const double slack = 1e-9 * width;
    for (std::size_t i = 0; i < t.size(); ++i)
        for (const double from : {t[i], t[i] - width}) {
            if (from < t.front() - slack || from + width > t.back() + slack) continue;
            const double mean = (until(from + width) - until(from)) / width;
            if (!(most >= mean)) most = mean;
        }
    return most;
}

/// Half of the time in which water that falls from the height at which it is let go, sqrt(2 g H), crosses one spacing or
/// cell at the hull [s]: no place is finer. 0 where none is let go.
double half_a_spacing_in_time(const RunRecord& record);
double half_a_spacing_in_time(const RunRecord& record) {
    const double fall = 2 * number_of(record, "gravity", 0) * number_of(record, "released_height", 0);
    return fall > 0 ? reading_of_height(record).above / std::sqrt(fall) : 0;
}

}  // namespace

double filter_of(const std::vector<RunRecord>& records, const std::string& table, const std::string& name) {
    double longest = 0;
    for (const RunRecord& r : records) longest = std::max(longest, number_of(r, peak_filter(table, name), 0));
    return longest > 0 ? longest : default_filter;
}

double largest_window_mean(std::span<const double> t, std::span<const double> x, double width) {
    double most = nan;
    for (std::size_t begin = 0; begin < t.size();) {
        if (!std::isfinite(x[begin])) {
            ++begin;
            continue;
        }
        std::size_t end = begin;
        while (end < t.size() && std::isfinite(x[end])) ++end;
        if (end - begin > 1) {
            const double here = largest_in_stretch(t.subspan(begin, end - begin), x.subspan(begin, end - begin), width);
            if (std::isfinite(here) && !(most >= here)) most = here;
        }
        begin = end;
    }
    return most;
}

double time_percentile(std::span<const double> t, std::span<const double> x, double part) {
    // Between two samples the history spends its time evenly between their values: below v it is for the share
    // (v - low) / (high - low). The percentile is found by halving the range.
    std::vector<std::pair<double, std::pair<double, double>>> steps;  // duration, low, high
    double total = 0, low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 1; i < t.size(); ++i) {
        if (!std::isfinite(x[i - 1]) || !std::isfinite(x[i])) continue;
        const auto [a, b] = std::minmax(x[i - 1], x[i]);
        steps.push_back({t[i] - t[i - 1], {a, b}});
        total += t[i] - t[i - 1];
        low = std::min(low, a), high = std::max(high, b);
    }
    if (!(total > 0)) return nan;
    const auto below = [&](double v) {
        double sum = 0;
        for (const auto& [duration, ends] : steps) {
            const auto [a, b] = ends;
            sum += duration * (v >= b ? 1 : v <= a ? 0 : (v - a) / (b - a));
        }
        return sum / total;
    };
    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        (below(middle) < part ? low : high) = middle;
    }
    return high;
}

double arrival_time(std::span<const double> t, std::span<const double> x, double threshold) {
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (!(x[i] > threshold)) continue;
        if (i == 0 || !std::isfinite(x[i - 1])) return t[i];
        return t[i - 1] + (t[i] - t[i - 1]) * (threshold - x[i - 1]) / (x[i] - x[i - 1]);
    }
    return nan;
}

ReadingBounds reading_of_arrival(std::span<const double> t, std::span<const double> x, double first, double peak,
                                 const RunRecord& record) {
    const auto passes = [&](double share) { return arrival_time(t, x, first + share * (peak - first)); };
    const auto length = [](double seconds) { return std::isfinite(seconds) ? std::max(0.0, seconds) : 0; };
    const double arrives = passes(arrival_share);
    const auto after = std::ranges::lower_bound(t, arrives);  // of the pair of samples between which it arrives
    const double between = after != t.begin() && after != t.end() ? *after - *std::prev(after) : 0,
                 sides = std::hypot(half_a_spacing_in_time(record), between / 2);
    return {std::hypot(sides, length(arrives - passes(arrival_share / 2))),
            std::hypot(sides, length(passes(2 * arrival_share) - arrives))};
}

ReadingBounds reading_of_height(const RunRecord& record) {
    const double half = number_of(record, "near_hull", 0) / 2;
    return {half, half};
}

void set_reading(MeanValue& value, const ReadingBounds& reading, const char* of) {
    if (!value.known) return;
    value.reading_below = reading.below, value.reading_above = reading.above;
    value.reading_of = of;
}

}  // namespace tw
