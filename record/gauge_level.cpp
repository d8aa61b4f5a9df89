#include "record/gauge_level.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tw {

namespace {

/// Sums over particles scatter about 1 in full water. Cut off at 1 they would lower the level by half of the scatter.
constexpr double most_share = 1.1;

/// What solids leave of the line.
std::vector<Stretch> gaps_of(const Stretch& line, const std::vector<Stretch>& solid, double narrowest) {
    std::vector<Stretch> gaps;
    double ground = line.low;
    const auto leave = [&](double ceiling) {
        if (ceiling - ground >= narrowest) gaps.push_back({ground, ceiling});
    };
    for (const Stretch& s : solid) {
        if (s.high <= line.low || s.low >= line.high) continue;
        leave(s.low);
        ground = std::max(ground, s.high);
    }
    leave(line.high);
    return gaps;
}

struct Filled {
    double height = 0;     ///< of the water in the gap, if it lay on the ground [m]
    double under_top = 0;  ///< share of water right under the gap's top [-]
};
Filled water_in(const Stretch& gap, const std::vector<GaugePart>& parts) {
    std::vector<GaugePart> within;
    for (const GaugePart& part : parts) {
        const Stretch at{std::max(part.at.low, gap.low), std::min(part.at.high, gap.high)};
        if (at.length() > 0) within.push_back({at, part.water});
    }
    const auto nearest_known = [&](std::size_t i) {
        for (std::size_t d = 1; d < within.size(); ++d)
            for (const std::size_t k : {i + d, i - d})  // above or, if as near, below
                if (k < within.size() && std::isfinite(within[k].water)) return within[k].water;
        return 0.0;
    };
    Filled filled;
    for (std::size_t i = 0; i < within.size(); ++i) {
        const double share = std::isfinite(within[i].water) ? within[i].water : nearest_known(i);
        filled.under_top = std::clamp(share, 0.0, 1.0);
        filled.height += std::clamp(share, 0.0, most_share) * within[i].at.length();
    }
    return filled;
}

}  // namespace

double gauge_level(const Stretch& line, const std::vector<Stretch>& solid, const std::vector<GaugePart>& parts,
                   double size) {
    const std::vector<Stretch> gaps = gaps_of(line, solid, size);
    if (gaps.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::size_t k = gaps.size() - 1;
    Filled filled = water_in(gaps[k], parts);
    while (k > 0 && filled.height < size / 2) filled = water_in(gaps[--k], parts);
    const bool covered = gaps[k].high < line.high && filled.under_top >= 0.5;
    return covered ? std::numeric_limits<double>::quiet_NaN() : gaps[k].low + filled.height;
}

}  // namespace tw
