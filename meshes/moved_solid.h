#pragma once
#include <Eigen/Geometry>

#include "base/vec3.h"

namespace tw {

/// A rigid solid that has moved from where it stood at the start.
struct MovedSolid {
    Box bounds;                                             ///< of its surface now
    Eigen::Isometry3d way = Eigen::Isometry3d::Identity();  ///< takes its points at the start to where they are now
};

}  // namespace tw
