#include "spray/load/sensor.h"

#include <algorithm>

namespace tw::spray {

Vec3 Sensor::across() const {
    const Vec3 n = normal.normalized(), level = Vec3::UnitZ().cross(n);
    return level.norm() > 1e-9 ? Vec3(level.normalized()) : Vec3(Vec3::UnitX());
}
Vec3 Sensor::along() const { return normal.normalized().cross(across()); }

Surface Sensor::surface() const {
    const Vec3 a = 0.5 * extent * across(), b = 0.5 * extent * along();
    return {{centre - a - b, centre + a - b, centre + a + b, centre - a + b}, {{0, 1, 2}, {0, 2, 3}}};
}

std::vector<Arrival> arrivals(const Sensor& sensor, int target, std::span<const Droplet> droplets,
                              std::span<const Landing> landings) {
    const Vec3 across = sensor.across(), along = sensor.along();
    std::vector<Arrival> result;
    for (std::size_t i = 0; i < landings.size(); ++i) {
        const Landing& l = landings[i];
        if (l.fate != Fate::hit || l.target != target || !(l.normal_speed > 0)) continue;
        const Vec3 from = l.place - sensor.centre;
        result.push_back({l.time, from.dot(across), from.dot(along), l.normal_speed, droplets[i].diameter});
    }
    std::ranges::sort(result, {}, &Arrival::time);
    return result;
}

}  // namespace tw::spray
