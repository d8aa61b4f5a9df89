#include "scene/solids/sea_wall.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "scene/box/tank_wave.h"

namespace tw {
namespace {

/// How far along the wave's way [m] a surface begins on the line through y and z [m]; infinite where it does not meet it.
double first_met(const Surface& surface, double y, double z, double way) {
    double first = infinite;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
        const auto area = [&](const Vec3& p, const Vec3& q) {
            return (p.y() - y) * (q.z() - z) - (p.z() - z) * (q.y() - y);
        };
        const double of_a = area(b, c), of_b = area(c, a), of_c = area(a, b), all = of_a + of_b + of_c;
        if (all == 0) continue;  // seen from the edge
        if (std::min({of_a / all, of_b / all, of_c / all}) < -1e-9) continue;
        first = std::min(first, way * (of_a * a.x() + of_b * b.x() + of_c * c.x()) / all);
    }
    return first;
}

}  // namespace

std::optional<SeaWall> sea_wall_of(const Scene& scene, const Obstacle& obstacle) {
    if (!scene.has_wave() || scene.motion.kind == Motion::Kind::stream) return {};
    const Box &tank = scene.domain.box, at = obstacle.surface.bounds();
    const double way = wave_scales(scene).direction, slack = scene.resolution.near_hull,
                 y = 0.5 * (tank.min.y() + tank.max.y());
    const bool closed =
        at.min.z() <= tank.min.z() + slack && at.min.y() <= tank.min.y() + slack && at.max.y() >= tank.max.y() - slack;
    if (!closed || !(at.max.z() > 0)) return {};
    const auto met = [&](double z) { return first_met(obstacle.surface, y, z, way); };
    const double low = 0.02 * at.max.z(), high = 0.98 * at.max.z(), cot = (met(high) - met(low)) / (high - low);
    if (!std::isfinite(cot) || cot < -1e-6) return {};
    const double foot = 0.98 * std::max(tank.min.z(), at.min.z()), below = (met(low) - met(foot)) / (low - foot);
    return SeaWall{at.max.z(), std::max(cot, 0.0), -tank.min.z(), std::abs(below - cot) < 0.02 * (1 + cot)};
}

std::optional<SeaWall> sea_wall_before(const Scene& scene, const Box& box) {
    if (!scene.has_wave()) return {};
    const double way = wave_scales(scene).direction, begins = way > 0 ? box.min.x() : -box.max.x();
    const Obstacle* highest = nullptr;
    for (const Obstacle& o : scene.obstacles) {
        const Box at = o.surface.bounds();
        if ((way > 0 ? at.min.x() : -at.max.x()) >= begins) continue;
        if (!highest || at.max.z() > highest->surface.bounds().max.z()) highest = &o;
    }
    return highest ? sea_wall_of(scene, *highest) : std::nullopt;
}

}  // namespace tw
