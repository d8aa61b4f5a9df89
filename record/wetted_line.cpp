#include "record/wetted_line.h"

#include <algorithm>
#include <cmath>

namespace tw {

void WettedLine::add_wet(const Vec3& place) {
    const long below = half_width_ > 0 ? std::lround(std::floor(place.y() / half_width_)) : 0;
    for (const long strip : {below, below + 1}) {
        const auto [at, first] = strips_.try_emplace(strip, place.x(), place.x());
        if (first) continue;
        at->second.first = std::min(at->second.first, place.x());
        at->second.second = std::max(at->second.second, place.x());
    }
}

double WettedLine::longest() const {
    double length = 0;
    for (const auto& [middle, extent] : strips_) length = std::max(length, extent.second - extent.first);
    return length;
}

}  // namespace tw
