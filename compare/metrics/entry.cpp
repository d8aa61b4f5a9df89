#include "compare/metrics/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/numbers.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/wave_surface.h"
#include "meshes/query.h"
#include "record/body_pose.h"
#include "record/raster_grid.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

/// What the voxels of a raster are to a body that stands somewhere in it.
enum class VoxelKind : std::uint8_t {
    far,     ///< farther than two voxel edges from its surface
    beside,  ///< outside, between one and two edges from it
    body     ///< inside, or nearer than an edge
};

/// Voxels that a body takes and those beside it, and where its axis is at each height.
struct BodyVoxels {
    std::vector<VoxelKind> kind;
    std::vector<double> axis_x,
        axis_y;  ///< per layer [m]; of the nearest layer that the body crosses; NaN: it is outside
};

/// The air of one frame: 0 water or body, 1 closed, 2 open (see entry.h).
enum class Air : std::uint8_t { none, closed, open };

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

/// The voxels of the body's cavity below layer `surface`, the first one above still water; closed air above it too.
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

struct Row {
    double open_volume = 0, closed_volume = 0, open_depth = 0, closed_top = nan;
    std::array<double, 2> cavity{0, 0}, waterline{nan, nan}, crown{0, 0};  ///< at smaller and larger x than the axis
    double crown_volume = 0;
};

/// Larger of the two; the other where one is no number.
double larger(double a, double b) { return a >= b || std::isnan(b) ? a : b; }

/// One frame of one record, with what its parts share.
struct Frame {
    const RasterGrid& grid;
    const RasterFrame& frame;
    const BodyVoxels& body;
    double level;
    int surface;          ///< layer above still water
    double voxel_volume;  ///< of two dimensions per metre

    /// 0: at smaller x than the axis, 1: at larger x.
    std::size_t side(double x, int layer) const {
        return x < body.axis_x[static_cast<std::size_t>(std::clamp(layer, 0, grid.nz - 1))] ? 0 : 1;
    }
    double x_of(std::size_t voxel) const { return grid.x(static_cast<int>(voxel % static_cast<std::size_t>(grid.nx))); }
    int layer_of(std::size_t voxel) const { return static_cast<int>(voxel / grid.columns()); }
};

void measure_cavity(const Frame& f, Row& row) {
    const std::vector<Air> air = air_of_frame(f.grid, f.frame, f.body);
    for (const std::size_t v : cavity_voxels(f.grid, air, f.body, f.surface)) {
        const int k = f.layer_of(v);
        if (air[v] == Air::open) {
            row.open_volume += f.voxel_volume;
            row.open_depth = std::max(row.open_depth, f.level - f.grid.z_low(k));
        } else {
            row.closed_volume += f.voxel_volume;
            row.closed_top = larger(f.grid.z_low(k + 1) - f.level, row.closed_top);
        }
        row.cavity[f.side(f.x_of(v), k)] += f.voxel_volume;
    }
}

void measure_waterline(const Frame& f, const std::vector<std::uint8_t>& water, Row& row) {
    for (int k = 0; k < f.grid.nz; ++k)
        for (int j = 0; j < f.grid.ny; ++j) {
            if (f.grid.ny > 1 &&
                !(std::abs(f.grid.y(j) - f.body.axis_y[static_cast<std::size_t>(k)]) <= f.grid.spec.voxel))
                continue;
            for (int i = 0; i < f.grid.nx; ++i) {
                const std::size_t v = f.grid.voxel(i, j, k);
                if (!water[v] || f.body.kind[v] != VoxelKind::beside) continue;
                double& line = row.waterline[f.side(f.grid.x(i), k)];
                line = larger(f.grid.z_low(k) + f.grid.spec.voxel * f.frame.water[v] / 255.0 - f.level, line);
            }
        }
}

void measure_crown(const Frame& f, const std::vector<std::uint8_t>& water, const std::vector<float>& cells, Row& row) {
    const std::vector<float> tops = sheet_tops(f.grid, f.frame, water);
    const double edge = f.grid.spec.voxel;
    for (int j = 0; j < f.grid.ny; ++j)
        for (int i = 0; i < f.grid.nx; ++i) {
            const std::size_t c = f.grid.column(i, j);
            const double top = tops[c];
            if (std::isfinite(top)) {
                const auto layer = static_cast<int>((top - f.grid.spec.origin.z()) / edge);
                double& crown = row.crown[f.side(f.grid.x(i), layer)];
                crown = std::max(crown, top - f.level);
            }
            const double cut = f.level + cells[c];
            for (int k = std::max(0, f.surface - 1); k < f.grid.nz; ++k) {
                const std::uint8_t share = f.frame.water[f.grid.voxel(i, j, k)];
                if (share < least_share) continue;
                const double below = std::max(0.0, (cut - f.grid.z_low(k)) / edge);  // water lies at a voxel's bottom
                row.crown_volume += f.voxel_volume * std::max(0.0, share / 255.0 - below);
            }
        }
}

}  // namespace

Table entry_series(const RunRecord& record, const BodyShape& shape, double level) {
    Table table;
    table.name = "entry_" + shape.table.substr(shape.table.find('_') + 1);
    const RasterGrid grid(record.raster);
    if (grid.empty() || shape.surface.triangles.empty()) return table;
    const SurfaceQuery query(shape.surface);
    const Box bounds = shape.surface.bounds();
    const std::vector<float> cells = surface_cells(record);
    const double edge = grid.spec.voxel, volume = grid.ny == 1 ? edge * edge : edge * edge * edge;
    const int surface = static_cast<int>(std::lround((level - grid.spec.origin.z()) / edge));
    const char* m3 = number_of(record, "dimensions", 3) == 2 ? "m3/m" : "m3";
    for (const RasterFrame& frame : record.frames) {
        const auto pose = body_pose(record, shape, frame.time);
        if (!pose) continue;
        const BodyVoxels body = body_voxels(grid, query, bounds, *pose);
        const Frame f{grid, frame, body, level, surface, volume};
        const std::vector<std::uint8_t> water = main_body(grid, frame);
        Row row;
        measure_cavity(f, row);
        measure_waterline(f, water, row);
        measure_crown(f, water, cells, row);
        const std::size_t at = table.append(frame.time);
        for (const auto& [name, unit, value] : {std::tuple{"open_volume", m3, row.open_volume},
                                                {"closed_volume", m3, row.closed_volume},
                                                {"open_depth", "m", row.open_depth},
                                                {"closed_top", "m", row.closed_top},
                                                {"cavity_low_x", m3, row.cavity[0]},
                                                {"cavity_high_x", m3, row.cavity[1]},
                                                {"waterline_low_x", "m", row.waterline[0]},
                                                {"waterline_high_x", "m", row.waterline[1]},
                                                {"crown_height", "m", std::max(row.crown[0], row.crown[1])},
                                                {"crown_low_x", "m", row.crown[0]},
                                                {"crown_high_x", "m", row.crown[1]},
                                                {"crown_volume", m3, row.crown_volume}})
            table.set(at, name, unit, value);
    }
    return table;
}

CavityClosure closure_of(const Table& entry, double noise) {
    CavityClosure c;
    if (entry.time.size() < 2) return c;
    const auto &depth = entry.find("open_depth")->values, &top = entry.find("closed_top")->values;
    const auto deepest = std::ranges::max_element(depth);
    c.deepest = *deepest;
    if (!(c.deepest > 2 * noise)) return c;
    const auto between = [&](std::size_t k) { return (entry.time[k - 1] + entry.time[k]) / 2; };
    const auto note = [&](std::size_t k) {
        if (std::isnan(c.half_step)) c.half_step = (entry.time[k] - entry.time[k - 1]) / 2;
    };
    bool was_open = false;
    for (std::size_t k = 1; k < depth.size() && std::isnan(c.seal); ++k) {
        was_open = was_open || depth[k - 1] > 2 * noise;
        if (!was_open || !std::isfinite(top[k])) continue;
        c.seal = between(k);
        c.seal_depth = -top[k];
        note(k);
    }
    for (auto k = static_cast<std::size_t>(deepest - depth.begin()) + 1; k < depth.size(); ++k) {
        if (depth[k] > noise * (1 + 1e-9)) continue;
        c.closed = between(k);
        note(k);
        break;
    }
    return c;
}

}  // namespace tw
