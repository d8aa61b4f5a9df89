#include "meshes/check/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "meshes/query.h"

namespace tw {

ThinWalls find_thin_walls(const Surface& surface, double limit) {
    const SurfaceQuery query(surface);
    const double nearly_parallel = std::cos(10 * std::numbers::pi / 180);
    const auto unit_normal = [&](int t) { return Vec3(surface.area_vector2(t).stableNormalized()); };
    struct Sample {
        double thickness, area;
        Vec3 place;
    };
    std::vector<Sample> samples;
    ThinWalls thin;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
        const double area = surface.area_vector2(t).norm() / 2;
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        // A large triangle may be thin in one part only: look from the centres of n x n equal parts of it.
        const int n = std::clamp(static_cast<int>(std::ceil(longest / limit)), 1, 32);
        const Vec3 u = (b - a) / n, v = (c - a) / n;
        const Vec3 normal = unit_normal(t);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < 2 * (n - i) - 1; ++j) {
                // Row i holds upright parts (even j) and inverted ones (odd j).
                const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
                const Vec3 p = a + (i + third) * v + (j / 2 + third) * u;
                const SurfaceQuery::Opposite opposite = query.opposite_side(t, p);
                if (opposite.triangle < 0 || opposite.distance >= limit) continue;
                if (-normal.dot(unit_normal(opposite.triangle)) < nearly_parallel) continue;
                samples.push_back({opposite.distance, area / (n * n), p});
                thin.area += samples.back().area;
            }
    }
    std::ranges::sort(samples, {}, &Sample::thickness);
    double below = 0;
    for (const Sample& sample : samples) {
        thin.typical = sample.thickness;
        thin.place = sample.place;
        if ((below += sample.area) >= thin.area / 2) break;
    }
    return thin;
}

}  // namespace tw
