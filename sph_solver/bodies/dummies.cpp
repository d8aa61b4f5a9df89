#include "sph_solver/bodies/dummies.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/cut_cell.h"

namespace tw {

Dummies make_dummies(const SurfaceQuery& query, const Box& bounds, double dp, double depth, const Box& region,
                     int dimensions) {
    Box box;
    box.min = bounds.min.cwiseMax(region.min).array() - dp;
    box.max = bounds.max.cwiseMin(region.max).array() + dp;
    // lattice cells [i dp, (i + 1) dp]; in 2-D one layer round y = 0
    const auto cell = [&](double x, bool up) { return static_cast<long>(up ? std::ceil(x / dp) : std::floor(x / dp)); };
    const long x0 = cell(box.min.x(), false), nx = cell(box.max.x(), true) - x0;
    const long y0 = dimensions == 3 ? cell(box.min.y(), false) : 0,
               ny = dimensions == 3 ? cell(box.max.y(), true) - y0 : 1;
    const long z0 = cell(box.min.z(), false), nz = cell(box.max.z(), true) - z0;
    if (nx <= 0 || ny <= 0 || nz <= 0) return {};

    const double half_diagonal = dp * std::sqrt(double(dimensions)) / 2;
    std::vector<Dummies> layers(static_cast<std::size_t>(nz));
    for_pieces(layers.size(), [&](std::size_t layer) {
        Dummies& out = layers[layer];
        const long k = static_cast<long>(layer);
        for (long j = 0; j < ny; ++j)
            for (long i = 0; i < nx;) {
                const Vec3 p((double(x0 + i) + 0.5) * dp, dimensions == 3 ? (double(y0 + j) + 0.5) * dp : 0.0,
                             (double(z0 + k) + 0.5) * dp);
                const double d = query.nearest(p).distance;
                if (std::abs(d) <= half_diagonal) {
                    const CutCell solid = cut_cell(p, Vec3::Constant(dp), dimensions == 2, [&](const Vec3& x) {
                        return query.nearest(x, 2 * dp).distance < 0;
                    });
                    if (solid.within > 0) {
                        out.places.push_back(solid.centroid);
                        out.volumes.push_back(solid.of(dimensions == 3 ? dp * dp * dp : dp * dp));
                    }
                } else if (d < 0 && d > -depth) {
                    out.places.push_back(p);
                    out.volumes.push_back(dimensions == 3 ? dp * dp * dp : dp * dp);
                }
                // nothing can happen before the surface (or the depth) comes into reach: skip the empty stretch
                const double clear = d > 0 ? d - half_diagonal : -d - depth;
                i += std::max(1L, static_cast<long>(clear / dp));
            }
    });
    Dummies all;
    for (const Dummies& layer : layers) {
        all.places.insert(all.places.end(), layer.places.begin(), layer.places.end());
        all.volumes.insert(all.volumes.end(), layer.volumes.begin(), layer.volumes.end());
    }
    return all;
}

}  // namespace tw
