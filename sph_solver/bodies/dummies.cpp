#include "sph_solver/bodies/dummies.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"

namespace tw {

namespace {
constexpr int samples = 6;  // per axis of a cut cell

/// Inner volume and centroid of the lattice cell round `centre`.
void cut_cell(const SurfaceQuery& query, const Vec3& centre, double dp, int dimensions, double& volume,
              Vec3& centroid) {
    int inside = 0;
    Vec3 sum = Vec3::Zero();
    const int ny = dimensions == 3 ? samples : 1;
    for (int k = 0; k < samples; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < samples; ++i) {
                const auto place = [&](int a, int n) { return ((a + 0.5) / n - 0.5) * dp; };
                const Vec3 p = centre + Vec3(place(i, samples), place(j, ny), place(k, samples));
                if (query.nearest(p, 2 * dp).distance < 0) {
                    ++inside;
                    sum += p;
                }
            }
    const int all = samples * samples * ny;
    volume = (dimensions == 3 ? dp * dp * dp : dp * dp) * inside / all;
    if (inside > 0) centroid = sum / inside;
}
}  // namespace

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
                    double volume = 0;
                    Vec3 centroid = p;
                    cut_cell(query, p, dp, dimensions, volume, centroid);
                    if (volume > 0) {
                        out.places.push_back(centroid);
                        out.volumes.push_back(volume);
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
