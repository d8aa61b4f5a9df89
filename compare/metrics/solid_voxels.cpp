#include "compare/metrics/solid_voxels.h"

#include <algorithm>
#include <cmath>

#include "meshes/query/predicates.h"
#include "record/solid_at_rest.h"

namespace tw {

namespace {

/// Heights along the lines through one raster at which a solid begins (+1) or ends (-1), added up to shares of voxels.
class Lines {
public:
    explicit Lines(const RasterGrid& grid) : grid_(grid), across_(grid.ny == 1 ? 1 : 3), share_(grid.voxels(), 0.0) {}

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double h = grid_.spec.voxel / 3;
        const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        const auto first = [&](double from, double origin) {
            return std::max(0, static_cast<int>(std::clamp(std::floor((from - origin) / h - 0.5), -1e6, 1e6)));
        };
        const auto end = [&](double to, double origin, int lines) {
            return std::min(lines, static_cast<int>(std::clamp(std::ceil((to - origin) / h + 0.5), -1e6, 1e6)));
        };
        const Vec3& origin = grid_.spec.origin;
        const bool flat = across_ == 1;
        const int j_first = flat ? 0 : first(low.y(), origin.y()),
                  j_end = flat ? 1 : end(high.y(), origin.y(), 3 * grid_.ny);
        const Vec3 normal = (b - a).cross(c - a);
        for (int j = j_first; j < j_end; ++j)
            for (int i = first(low.x(), origin.x()); i < end(high.x(), origin.x(), 3 * grid_.nx); ++i) {
                const Vec3 below(origin.x() + (i + 0.5) * h, flat ? grid_.y(0) : origin.y() + (j + 0.5) * h,
                                 low.z() - 1);
                const int sign = crossing_above(a, b, c, below);  // +1: upwards the solid ends there
                if (sign == 0 || normal.z() == 0) continue;
                const double z =
                    a.z() - (normal.x() * (below.x() - a.x()) + normal.y() * (below.y() - a.y())) / normal.z();
                above(grid_.column(i / 3, j / 3), std::clamp(z, low.z(), high.z()), -sign);
            }
    }
    std::vector<std::uint8_t> shares() const {
        std::vector<std::uint8_t> all(share_.size());
        const double lines = 3.0 * across_;
        for (std::size_t v = 0; v < all.size(); ++v)
            all[v] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share_[v] / lines, 0.0, 1.0)));
        return all;
    }

private:
    /// From a height on upwards one solid more (+1) or less (-1) along a line of this column.
    void above(std::size_t column, double z, int sign) {
        for (int k = 0; k < grid_.nz; ++k)
            share_[static_cast<std::size_t>(k) * grid_.columns() + column] +=
                sign * std::clamp((grid_.z_low(k + 1) - z) / grid_.spec.voxel, 0.0, 1.0);
    }

    RasterGrid grid_;
    int across_;
    std::vector<double> share_;
};

}  // namespace

std::vector<std::uint8_t> solid_voxels(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || std::ranges::none_of(record.bodies, is_at_rest)) return {};
    Lines lines(grid);
    for (const BodyShape& body : record.bodies)
        if (is_at_rest(body))
            for (int t = 0; t < static_cast<int>(body.surface.triangles.size()); ++t)
                lines.add(body.surface.corner(t, 0), body.surface.corner(t, 1), body.surface.corner(t, 2));
    return lines.shares();
}

}  // namespace tw
