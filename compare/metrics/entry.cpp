#include "compare/metrics/entry.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "compare/metrics/entry_voxels.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/wave_surface.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

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
