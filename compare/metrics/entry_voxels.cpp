#include "compare/metrics/entry_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/metrics/raster_columns.h"

namespace tw {
namespace {

struct Place {
    int i, j, k;
};

Place place_of(const RasterGrid& grid, std::size_t voxel) {
    const auto column = static_cast<int>(voxel % grid.columns());
    return {column % grid.nx, column / grid.nx, static_cast<int>(voxel / grid.columns())};
}

/// Visits `seeds` and all that hangs together with them through the faces of voxels that `enters(voxel, layer)`
/// accepts; `visited` is marked.
template <class Enters>
std::vector<std::size_t> connected(const RasterGrid& grid, std::vector<std::size_t> seeds,
                                   std::vector<std::uint8_t>& visited, Enters enters) {
    std::vector<std::size_t> found;
    for (const std::size_t seed : seeds) visited[seed] = 1;
    while (!seeds.empty()) {
        const std::size_t voxel = seeds.back();
        seeds.pop_back();
        found.push_back(voxel);
        const Place at = place_of(grid, voxel);
        for (const auto& [di, dj, dk] :
             {std::array{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
            const int i = at.i + di, j = at.j + dj, k = at.k + dk;
            if (i < 0 || j < 0 || k < 0 || i >= grid.nx || j >= grid.ny || k >= grid.nz) continue;
            const std::size_t next = grid.voxel(i, j, k);
            if (visited[next] || !enters(next, k)) continue;
            visited[next] = 1;
            seeds.push_back(next);
        }
    }
    return found;
}

/// Layers that the body does not cross take the axis of the nearest one that it does.
void carry_on(std::vector<double>& axis) {
    const auto known = [](double x) { return std::isfinite(x); };
    const auto first = std::ranges::find_if(axis, known);
    if (first == axis.end()) return;
    std::fill(axis.begin(), first, *first);
    for (auto at = first; at != axis.end(); ++at)
        if (!known(*at)) *at = *(at - 1);
}

}  // namespace

BodyVoxels body_voxels(const RasterGrid& grid, const SurfaceQuery& shape, const Box& bounds, const BodyPose& pose) {
    const double edge = grid.spec.voxel, reach = 2 * edge;
    BodyVoxels body{std::vector(grid.voxels(), VoxelKind::far),
                    std::vector(static_cast<std::size_t>(grid.nz), std::nan("")),
                    std::vector(static_cast<std::size_t>(grid.nz), std::nan(""))};
    Box now{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 c =
            pose(Vec3(corner & 1 ? bounds.max.x() : bounds.min.x(), corner & 2 ? bounds.max.y() : bounds.min.y(),
                      corner & 4 ? bounds.max.z() : bounds.min.z()));
        now.min = now.min.cwiseMin(c), now.max = now.max.cwiseMax(c);
    }
    const auto first = [&](int axis) {
        const double k = std::floor((now.min[axis] - reach - grid.spec.origin[axis]) / edge);
        return static_cast<int>(std::clamp(k, 0.0, double(grid.spec.count[static_cast<std::size_t>(axis)])));
    };
    const auto end = [&](int axis) {
        const double k = std::ceil((now.max[axis] + reach - grid.spec.origin[axis]) / edge);
        return static_cast<int>(std::clamp(k, 0.0, double(grid.spec.count[static_cast<std::size_t>(axis)])));
    };
    for (int k = first(2); k < end(2); ++k) {
        double x = 0, y = 0;
        int taken = 0;
        for (int j = first(1); j < end(1); ++j)
            for (int i = first(0); i < end(0); ++i) {
                const Vec3 centre(grid.x(i), grid.ny == 1 ? pose.centre.y() : grid.y(j), grid.z_low(k) + edge / 2);
                const double distance = shape.nearest(pose.back(centre), reach).distance;
                if (distance >= reach) continue;
                body.kind[grid.voxel(i, j, k)] = distance < edge ? VoxelKind::body : VoxelKind::beside;
                if (distance < edge) x += centre.x(), y += centre.y(), ++taken;
            }
        if (taken > 0)
            body.axis_x[static_cast<std::size_t>(k)] = x / taken, body.axis_y[static_cast<std::size_t>(k)] = y / taken;
    }
    carry_on(body.axis_x);
    carry_on(body.axis_y);
    return body;
}

std::vector<Air> air_of_frame(const RasterGrid& grid, const RasterFrame& frame, const BodyVoxels& body) {
    std::vector<Air> air(grid.voxels(), Air::none);
    for (std::size_t v = 0; v < air.size(); ++v)
        if (frame.water[v] < half_full && body.kind[v] != VoxelKind::body) air[v] = Air::closed;
    std::vector<std::size_t> top;
    for (std::size_t v = air.size() - grid.columns(); v < air.size(); ++v)
        if (air[v] == Air::closed) top.push_back(v);
    std::vector<std::uint8_t> visited(air.size());
    for (const std::size_t v :
         connected(grid, std::move(top), visited, [&](std::size_t v, int) { return air[v] == Air::closed; }))
        air[v] = Air::open;
    return air;
}

std::vector<std::size_t> cavity_voxels(const RasterGrid& grid, const std::vector<Air>& air, const BodyVoxels& body,
                                       int surface) {
    const std::size_t least = grid.ny == 1 ? 4 : 8;  // 2^d
    std::vector<std::size_t> cavity;
    std::vector<std::uint8_t> visited(air.size());
    const std::size_t below = grid.columns() * static_cast<std::size_t>(std::clamp(surface, 0, grid.nz));
    for (std::size_t seed = 0; seed < below; ++seed) {
        if (visited[seed] || air[seed] == Air::none || body.kind[seed] != VoxelKind::beside) continue;
        const Air kind = air[seed];
        const auto part = connected(grid, {seed}, visited, [&](std::size_t v, int k) {
            return air[v] == kind && (kind == Air::closed || k < surface);
        });
        if (kind == Air::open || part.size() >= least) cavity.insert(cavity.end(), part.begin(), part.end());
    }
    return cavity;
}

}  // namespace tw
