#pragma once
#include <algorithm>

#include "base/vec3.h"

namespace tw {

/// The table of the scene's boxes: the volume of the water in each [m3], in two dimensions per metre of span.
inline constexpr const char* volume_table = "volume";

/// How much of a cuboid round `centre`, of these edges [m], lies in a box [-]. The volume of the water in a box is, of
/// particles and of cells,
///
///   V = sum_i water_i share_in_box(box, x_i, edges_i)   [m3]
///
/// each spreading its water evenly over such a cuboid. The water of a particle is its mass over the density at rest: the
/// weak compression of the method is no loss of water.
inline double share_in_box(const Box& box, const Vec3& centre, const Vec3& edges) {
    double share = 1;
    for (int a = 0; a < 3 && share > 0; ++a) {
        const double low = std::max(box.min[a], centre[a] - edges[a] / 2),
                     high = std::min(box.max[a], centre[a] + edges[a] / 2);
        share *= std::clamp((high - low) / edges[a], 0.0, 1.0);
    }
    return share;
}

}  // namespace tw
