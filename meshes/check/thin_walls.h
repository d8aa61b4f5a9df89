#pragma once
#include "meshes/surface.h"

namespace tw {

/// Where a hull is a plate or fin: opposite faces within 10 degrees of parallel and closer than `limit` [m]. The edges
/// of a wedge (keel, chine, stem, transom) are thin at any resolution and are left out by the angle.
struct ThinWalls {
    double area = 0;            ///< of the surface on both sides of the thin parts [m2]
    double typical = 0;         ///< thickness that half of this area falls below [m]
    Vec3 place = Vec3::Zero();  ///< where it has that thickness [m]
};
ThinWalls find_thin_walls(const Surface& surface, double limit);

}  // namespace tw
