#include "compare/metrics/raster_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

constexpr float no_height = std::numeric_limits<float>::quiet_NaN();
/// What a solid leaves of a voxel counts from an eighth on, in 255ths: water in less is mostly what was poured past it.
constexpr int least_room = 32;

int solid_in(const SolidVoxels& solid, std::size_t v) { return solid.empty() ? 0 : solid[v]; }

}  // namespace

SolidVoxels solid_voxels(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || std::ranges::none_of(record.bodies, is_at_rest)) return {};
    Lines lines(grid);
    for (const BodyShape& body : record.bodies)
        if (is_at_rest(body))
            for (int t = 0; t < static_cast<int>(body.surface.triangles.size()); ++t)
                lines.add(body.surface.corner(t, 0), body.surface.corner(t, 1), body.surface.corner(t, 2));
    return lines.shares();
}

std::vector<std::uint8_t> main_body(const RasterGrid& grid, const RasterFrame& frame, const SolidVoxels& solid) {
    const auto is_water = [&](std::size_t v) {
        const int room = 255 - solid_in(solid, v);
        return room == 255 ? frame.water[v] >= half_full : room >= least_room && 2 * frame.water[v] >= room;
    };
    std::vector<int> label(grid.voxels(), 0);
    std::vector<std::array<int, 3>> open;
    int labels = 0, largest = 0;
    std::size_t largest_size = 0;
    for (int k0 = 0; k0 < grid.nz; ++k0)
        for (int j0 = 0; j0 < grid.ny; ++j0)
            for (int i0 = 0; i0 < grid.nx; ++i0) {
                const std::size_t seed = grid.voxel(i0, j0, k0);
                if (label[seed] != 0 || !is_water(seed)) continue;
                label[seed] = ++labels;
                open.assign(1, {i0, j0, k0});
                std::size_t size = 0;
                while (!open.empty()) {
                    const auto [i, j, k] = open.back();
                    open.pop_back();
                    ++size;
                    for (int c = std::max(k - 1, 0); c <= std::min(k + 1, grid.nz - 1); ++c)
                        for (int b = std::max(j - 1, 0); b <= std::min(j + 1, grid.ny - 1); ++b)
                            for (int a = std::max(i - 1, 0); a <= std::min(i + 1, grid.nx - 1); ++a) {
                                const std::size_t v = grid.voxel(a, b, c);
                                if (label[v] != 0 || !is_water(v)) continue;
                                label[v] = labels;
                                open.push_back({a, b, c});
                            }
                }
                if (size > largest_size) {
                    largest_size = size;
                    largest = labels;
                }
            }
    std::vector<std::uint8_t> body(grid.voxels());
    for (std::size_t v = 0; v < body.size(); ++v) body[v] = largest != 0 && label[v] == largest;
    return body;
}

std::vector<float> sheet_tops(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body,
                              const SolidVoxels& solid) {
    std::vector<float> top(grid.columns(), no_height);
    for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const std::size_t v = grid.voxel(i, j, k);
                if (!body[v]) continue;
                // Water that only part-fills the voxel above belongs to the same surface.
                const double above = k + 1 < grid.nz && !body[grid.voxel(i, j, k + 1)]
                                         ? frame.water[grid.voxel(i, j, k + 1)] / 255.0
                                         : 0;
                const double here = std::min(1.0, (frame.water[v] + solid_in(solid, v)) / 255.0);
                top[grid.column(i, j)] = static_cast<float>(grid.z_low(k) + grid.spec.voxel * (here + above));
            }
    return top;
}

std::vector<float> elevations(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body,
                              const SolidVoxels& solid) {
    std::vector<float> height(grid.columns(), no_height);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            double sum = 0, solid_above = 0;  // above the highest water so far
            bool any = false, covered = false;
            for (int k = 0; k < grid.nz; ++k) {
                const std::size_t v = grid.voxel(i, j, k);
                const bool on_body = k > 0 && body[grid.voxel(i, j, k - 1)];
                const double taken = solid_in(solid, v) / 255.0;
                if (!body[v] && on_body) covered = taken >= 0.5;
                if (!body[v] && !on_body) {
                    solid_above += taken;
                    continue;
                }
                any = true;
                sum += frame.water[v] / 255.0;
                solid_above += taken;
                if (!body[v]) continue;
                sum += solid_above;
                solid_above = 0, covered = false;
            }
            if (any && !covered)
                height[grid.column(i, j)] = static_cast<float>(grid.spec.origin.z() + grid.spec.voxel * sum);
        }
    return height;
}

std::vector<std::uint8_t> under_hull(const RasterGrid& grid, const Surface& hull) {
    std::vector<std::uint8_t> covered(grid.columns(), 0);
    if (grid.empty()) return covered;
    const auto cross = [](const Vec3& a, const Vec3& b, double x, double y) {
        return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    };
    for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t) {
        const Vec3 a = hull.corner(t, 0), b = hull.corner(t, 1), c = hull.corner(t, 2);
        const double x_min = std::min({a.x(), b.x(), c.x()}), x_max = std::max({a.x(), b.x(), c.x()});
        const double y_min = std::min({a.y(), b.y(), c.y()}), y_max = std::max({a.y(), b.y(), c.y()});
        const auto index = [&](double at, double origin, int count) {
            return static_cast<int>(std::clamp((at - origin) / grid.spec.voxel, -1.0, static_cast<double>(count)));
        };
        for (int j = std::max(0, index(y_min, grid.spec.origin.y(), grid.ny));
             j <= std::min(grid.ny - 1, index(y_max, grid.spec.origin.y(), grid.ny)); ++j)
            for (int i = std::max(0, index(x_min, grid.spec.origin.x(), grid.nx));
                 i <= std::min(grid.nx - 1, index(x_max, grid.spec.origin.x(), grid.nx)); ++i) {
                const double x = grid.x(i), y = grid.y(j);
                const double s = cross(a, b, x, y), u = cross(b, c, x, y), v = cross(c, a, x, y);
                if ((s >= 0 && u >= 0 && v >= 0) || (s <= 0 && u <= 0 && v <= 0)) covered[grid.column(i, j)] = 1;
            }
    }
    return covered;
}

}  // namespace tw
