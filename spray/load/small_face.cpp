#include "spray/load/small_face.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tw::spray {

double pressure_of_one(double normal_speed, double diameter, double face, const Liquid& liquid) {
    const double section = std::numbers::pi / 4 * diameter * diameter;
    return peak_force(normal_speed, diameter, liquid) / std::max(section, face * face);
}

FaceHits face_hits(std::span<const Arrival> arrivals, double extent, double face, const Liquid& liquid) {
    FaceHits hits;
    std::vector<std::pair<double, double>> pressures;  // with how many touches
    for (const Arrival& a : arrivals) {
        const double d = a.diameter;
        const double touches = (face * face + 2 * face * d + std::numbers::pi / 4 * d * d) / (extent * extent);
        pressures.emplace_back(pressure_of_one(a.normal_speed, d, face, liquid), touches);
        hits.touches += touches;
    }
    hits.chance = -std::expm1(-hits.touches);
    if (pressures.empty()) return hits;
    std::ranges::sort(pressures);
    const auto at = [&](double share) {
        double below = 0;
        for (const auto& [p, touches] : pressures)
            if ((below += touches) >= share * hits.touches) return p;
        return pressures.back().first;
    };
    hits.median = at(0.5), hits.high = at(0.95), hits.largest = pressures.back().first;
    return hits;
}

}  // namespace tw::spray
