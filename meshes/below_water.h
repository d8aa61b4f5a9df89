#pragma once
#include <algorithm>
#include <array>

#include "meshes/surface.h"

namespace tw {

/// Share of a triangle's area that lies below z = 0 (still water).
inline double share_below_water(const Surface& surface, int triangle) {
    std::array<double, 3> z{};
    for (int k = 0; k < 3; ++k) z[static_cast<std::size_t>(k)] = surface.corner(triangle, k).z();
    std::ranges::sort(z);
    // The plane z = 0 cuts off a similar triangle below it, or above it.
    if (z[0] < 0 && z[1] >= 0) return z[0] * z[0] / ((z[1] - z[0]) * (z[2] - z[0]));
    if (z[1] < 0 && z[2] > 0) return 1 - z[2] * z[2] / ((z[2] - z[0]) * (z[2] - z[1]));
    return z[2] <= 0 ? 1 : 0;
}

}  // namespace tw
