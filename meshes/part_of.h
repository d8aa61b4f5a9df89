#pragma once
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// The triangles of a surface that `keep(triangle)` wants, and the points they use.
template <class Keep>
Surface part_of(const Surface& surface, const Keep& keep) {
    Surface kept;
    std::vector<int> number(surface.points.size(), -1);
    for (auto t : surface.triangles) {
        if (!keep(t)) continue;
        for (int& corner : t) {
            int& n = number[static_cast<std::size_t>(corner)];
            if (n < 0) {
                n = static_cast<int>(kept.points.size());
                kept.points.push_back(surface.points[static_cast<std::size_t>(corner)]);
            }
            corner = n;
        }
        kept.triangles.push_back(t);
    }
    return kept;
}

}  // namespace tw
