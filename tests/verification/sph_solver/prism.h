#pragma once
#include <utility>
#include <vector>

#include "meshes/mass_properties.h"
#include "meshes/surface.h"

namespace tw {

/// A prism along y from -half_width to half_width; its section is convex, counter-clockwise seen from -y.
inline Surface prism_along_y(const std::vector<std::pair<double, double>>& section, double half_width) {
    Surface s;
    const int n = static_cast<int>(section.size());
    for (double y : {-half_width, half_width})
        for (const auto& [x, z] : section) s.points.emplace_back(x, y, z);
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        s.triangles.push_back({k, next, n + k});
        s.triangles.push_back({next, n + next, n + k});
    }
    for (int k = 1; k + 1 < n; ++k) {
        s.triangles.push_back({0, k + 1, k});
        s.triangles.push_back({n, n + k, n + k + 1});
    }
    if (mass_properties(s).volume < 0)
        for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

}  // namespace tw
