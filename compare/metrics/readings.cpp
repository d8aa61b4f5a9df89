#include "compare/metrics/readings.h"

#include <algorithm>
#include <cmath>

#include "compare/metrics/probe_peaks.h"
#include "record/record_numbers.h"

namespace tw {

double half_a_spacing_in_time(const RunRecord& record) {
    const double fall = 2 * number_of(record, "gravity", 0) * number_of(record, "released_height", 0);
    return fall > 0 ? reading_of_height(record).above / std::sqrt(fall) : 0;
}

Reading reading_of_arrival(std::span<const double> t, std::span<const double> x, double first, double peak,
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

Reading reading_of_height(const RunRecord& record) {
    const double half = number_of(record, "near_hull", 0) / 2;
    return {half, half};
}

void set_reading(MeanValue& value, const Reading& reading, const char* of) {
    if (!value.known) return;
    value.reading_below = reading.below, value.reading_above = reading.above;
    value.reading_of = of;
}

}  // namespace tw
