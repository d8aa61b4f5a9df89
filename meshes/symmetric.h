#pragma once
#include "meshes/surface.h"

namespace tw {

/// How far the two sides of a surface differ: the largest distance of a mirrored corner (about y = 0) from the surface
/// [m], and the corner.
struct Asymmetry {
    double distance = 0;        ///< [m]
    Vec3 place = Vec3::Zero();  ///< [m]
};
Asymmetry asymmetry(const Surface& closed_surface);

/// The part of a closed surface at y > 0 and its mirror image about y = 0, joined in that plane. Corners nearer to the
/// plane than `reach` [m] are moved into it first, so that a keel line beside it leaves no slivers.
Surface made_symmetric(const Surface& closed_surface, double reach);

}  // namespace tw
