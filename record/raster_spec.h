#pragma once
#include <array>

#include "base/vec3.h"

namespace tw {

/// Voxels into which both methods pour their water, so that splash is measured alike (raster.h).
struct RasterSpec {
    Vec3 origin = Vec3::Zero();         ///< low corner [m]
    double voxel = 0;                   ///< edge of a voxel [m]
    std::array<int, 3> count{0, 0, 0};  ///< voxels along x, y, z
    bool chosen = false;  ///< the edge was written in the scene; else it follows from the particle spacing
};

}  // namespace tw
