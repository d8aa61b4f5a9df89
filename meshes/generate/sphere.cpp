#include <map>

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// An octahedron halved `level` times, its corners moved out to the sphere: nearly equal triangles, symmetric about all
/// three planes.
Surface make_sphere(const std::map<std::string, double>& v) {
    const double radius = v.at("diameter") / 2;
    Surface s{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int level = 0; level < static_cast<int>(v.at("level")); ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int i, int j) {
            const auto [entry, fresh] = middles.try_emplace(std::minmax(i, j), static_cast<int>(s.points.size()));
            if (fresh)
                s.points.push_back(
                    (s.points[static_cast<std::size_t>(i)] + s.points[static_cast<std::size_t>(j)]).normalized());
            return entry->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : s.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        s.triangles = std::move(finer);
    }
    for (Vec3& p : s.points) p = radius * (p + Vec3::UnitZ());
    return s;
}
}  // namespace

HullShape sphere_shape() {
    return {"sphere",
            "sphere, triangulated from an octahedron",
            {{"diameter", "m", "", 1, 1e-4, 100}, {"level", "-", "halvings of the octahedron's edges", 5, 1, 8}},
            make_sphere};
}

}  // namespace tw
