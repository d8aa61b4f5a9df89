#pragma once
#include <algorithm>

#include "meshes/surface.h"

namespace tw {

/// True when a triangle's height over its longest side is below 1e-7 of that side: single-precision rounding, not
/// shape.
inline bool has_no_area(const Surface& s, int t) {
    const double longest2 =
        std::max({(s.corner(t, 1) - s.corner(t, 0)).squaredNorm(), (s.corner(t, 2) - s.corner(t, 1)).squaredNorm(),
                  (s.corner(t, 0) - s.corner(t, 2)).squaredNorm()});
    return s.area_vector2(t).norm() <= 1e-7 * longest2;
}

}  // namespace tw
