#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tw {

using Vec3 = Eigen::Vector3d;

/// Axis-aligned box [m].
struct Box {
    Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< [m]
    Vec3 size() const { return max - min; }
    double volume() const { return size().prod(); }
    bool contains(const Vec3& p) const { return (p.array() >= min.array()).all() && (p.array() <= max.array()).all(); }
};

}  // namespace tw
