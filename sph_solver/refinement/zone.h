#pragma once
#include <vector>

#include "base/vec3.h"

namespace tw {

/// Where the water belongs to a level of finer particles: a union of boxes. A face at infinity is no edge: there the
/// zone ends at a wall, a symmetry plane or the open sky.
class Zone {
public:
    Zone() = default;
    explicit Zone(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}
    /// Distance from the edge [m], positive outside, negative inside.
    double outside(const Vec3& x) const;
    const std::vector<Box>& boxes() const { return boxes_; }

private:
    std::vector<Box> boxes_;
};

}  // namespace tw
