#include "meshes/query/solid_column.h"

#include <algorithm>

#include "meshes/query/predicates.h"

namespace tw {

void SolidColumn::add(const Surface& surface) {
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
        const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        if (x_ < low.x() || x_ > high.x() || y_ < low.y() || y_ > high.y()) continue;
        const Vec3 below(x_, y_, low.z() - (1 + high.z() - low.z()));
        const int leaves = crossing_above(a, b, c, below);
        const Vec3 normal = (b - a).cross(c - a);
        if (leaves == 0 || normal.z() == 0) continue;
        const double z = a.z() - (normal.x() * (x_ - a.x()) + normal.y() * (y_ - a.y())) / normal.z();
        faces_.push_back({std::clamp(z, low.z(), high.z()), -leaves});
    }
}

std::vector<Stretch> SolidColumn::stretches() const {
    std::vector<Face> faces = faces_;
    // where one ends and the next begins at the same height, there is no gap
    std::ranges::sort(faces, [](const Face& a, const Face& b) { return a.z != b.z ? a.z < b.z : a.enters > b.enters; });
    std::vector<Stretch> solid;
    int inside = 0;
    for (const Face& face : faces) {
        const int before = inside;
        inside += face.enters;
        if (before <= 0 && inside > 0) solid.push_back({face.z, face.z});
        if (before > 0 && inside <= 0) solid.back().high = face.z;
    }
    return solid;
}

}  // namespace tw
