#pragma once
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "meshes/check/edges.h"

namespace tw {

/// Size and flatness of a hole, by its rim.
struct Hole {
    Vec3 centre = Vec3::Zero();  ///< [m]
    double diameter = 0;         ///< twice the largest distance of a rim point from the centre [m]
    double unevenness = 0;       ///< largest distance of a rim point from the plane through the centre [m]
};

inline Hole measured(const Surface& s, const Loop& loop) {
    Hole hole;
    const auto point = [&](std::size_t i) { return s.points[static_cast<std::size_t>(loop[i % loop.size()])]; };
    for (std::size_t i = 0; i < loop.size(); ++i) hole.centre += point(i) / static_cast<double>(loop.size());
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 a = point(i) - hole.centre, b = point(i + 1) - hole.centre;
        normal += a.cross(b);
        hole.diameter = std::max(hole.diameter, 2 * a.norm());
    }
    normal.stableNormalize();
    for (std::size_t i = 0; i < loop.size(); ++i)
        hole.unevenness = std::max(hole.unevenness, std::abs(normal.dot(point(i) - hole.centre)));
    return hole;
}

/// A hole that repair may fill: up to 5 % of the hull's diagonal wide, and flat to 5 % of its width.
inline constexpr double widest_filled_hole = 0.05;
inline bool may_be_filled(const Hole& hole, double diagonal) {
    return hole.diameter <= widest_filled_hole * diagonal && hole.unevenness <= 0.05 * hole.diameter;
}

}  // namespace tw
