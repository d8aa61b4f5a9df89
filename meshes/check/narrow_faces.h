#pragma once
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// A smooth part of a surface that sharp edges bound, and that is narrow: the riser of a step, the flat of a chine, a rail.
struct NarrowFace {
    double width = 0, length = 0;  ///< [m]
    Vec3 middle = Vec3::Zero();    ///< [m]
};

/// The parts narrower than `width` [m] and at least four times as long as wide, whose middle lies in `within`, the narrowest
/// first. Triangles belong to one part where the edge between them is duller than 30 degrees; of a part of area A and
/// perimeter P the width is that of the strip which has both, (P - sqrt(P^2 - 16 A))/4.
std::vector<NarrowFace> narrow_faces(const Surface& surface, const Box& within, double width);

}  // namespace tw
