#include "compare/metrics/splash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/wave_surface.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

/// Water above a cut-off by layers: volume and lower edge of each.
struct WaterAbove {
    std::vector<double> low, high, volume;
    double total = 0;

    /// Height below which the share `q` of the volume lies, linear inside a layer [m].
    double height(double q) const {
        if (!(total > 0)) return nan;
        double below = 0;
        for (std::size_t k = 0; k < volume.size(); ++k) {
            if (below + volume[k] >= q * total && volume[k] > 0)
                return low[k] + (high[k] - low[k]) * (q * total - below) / volume[k];
            below += volume[k];
        }
        return high.back();
    }
    /// sum w V (z - level): the potential energy where w = rho g.
    double moment(double weight, double level) const {
        double sum = 0;
        for (std::size_t k = 0; k < volume.size(); ++k) sum += weight * volume[k] * (0.5 * (low[k] + high[k]) - level);
        return sum;
    }
};

/// `cut_off`: height per column from which on water counts [m]. Water lies at the bottom of a voxel.
WaterAbove water_above(const RasterGrid& grid, const RasterFrame& frame, const std::vector<double>& cut_off) {
    WaterAbove air;
    const double edge = grid.spec.voxel;
    for (int k = 0; k < grid.nz; ++k) {
        const double low = grid.z_low(k);
        double sum = 0, lowest = grid.z_low(k + 1);
        for (std::size_t c = 0; c < grid.columns(); ++c) {
            const std::uint8_t water = frame.water[static_cast<std::size_t>(k) * grid.columns() + c];
            if (water < least_share) continue;
            const double share = water / 255.0;
            const double above = share - std::max(0.0, (cut_off[c] - low) / edge);
            if (above <= 1e-9) continue;
            sum += above;
            lowest = std::min(lowest, std::max(low, cut_off[c]));
        }
        air.low.push_back(lowest);
        air.high.push_back(grid.z_low(k + 1));
        air.volume.push_back(sum * edge * edge * edge);
        air.total += air.volume.back();
    }
    return air;
}

/// x of the hull's aftmost point [m].
double stern_of(const RunRecord& record) {
    double stern = -infinite;
    for (const Vec3& p : record.hull.points) stern = std::max(stern, p.x());
    return stern;
}

/// The columns behind the hull, and how far they reach along x [m]: none of a section, or where no hull is.
struct Wake {
    std::vector<double> cut_off;  ///< still water behind the hull, beyond all heights elsewhere [m]
    double length = 0;
};
Wake wake_of(const RunRecord& record, const RasterGrid& grid, double level) {
    Wake wake{std::vector<double>(grid.columns(), infinite)};
    if (!is_stream(record) || record.hull.points.empty() || number_of(record, "dimensions", 3) == 2) return wake;
    const double stern = stern_of(record);
    for (int i = 0; i < grid.nx; ++i) {
        if (grid.x(i) <= stern) continue;
        wake.length += grid.spec.voxel;
        for (int j = 0; j < grid.ny; ++j) wake.cut_off[grid.column(i, j)] = level;
    }
    return wake;
}

}  // namespace

double still_level(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    if (is_stream(record) || record.frames.empty() || grid.empty()) return 0;
    double water = 0;
    for (const std::uint8_t v : record.frames.front().water) water += v / 255.0;
    const SolidVoxels solid = solid_voxels(record);
    for (int k = 0; k < grid.nz; ++k) {
        auto room = static_cast<double>(grid.columns());
        for (std::size_t c = 0; !solid.empty() && c < grid.columns(); ++c)
            room -= solid[static_cast<std::size_t>(k) * grid.columns() + c] / 255.0;
        if (water <= room) return grid.z_low(k) + (room > 0 ? grid.spec.voxel * water / room : 0);
        water -= room;
    }
    return grid.z_low(grid.nz);
}

Table splash_series(const RunRecord& record, double level) {
    Table table;
    table.name = "splash";
    const RasterGrid grid(record.raster);
    if (grid.empty()) return table;
    const double factor = number_of_text(record, "symmetry_factor", 1);
    const double weight = number_of(record, "density", 1000) * number_of(record, "gravity", 9.81);
    table.columns = {{"sheet_height", "m", {}},
                     {"p95", "m", {}},
                     {"p99", "m", {}},
                     {"p99_9", "m", {}},
                     {"airborne_volume", "m3", {}},
                     {"airborne_energy", "J", {}},
                     {"raw_height", "m", {}},
                     {"raised_area", "m2", {}},
                     {"raised_mean", "m", {}},
                     {"raised_p90", "m", {}}};
    const auto covered = under_hull(grid, record.hull);
    const auto cells = surface_cells(record);
    const SolidVoxels solid = solid_voxels(record);
    const Wake wake = wake_of(record, grid, level);
    std::vector<double> cut_off(grid.columns());
    for (const RasterFrame& frame : record.frames) {
        const auto tops = sheet_tops(grid, frame, main_body(grid, frame, solid), solid);
        const auto wave = wave_surface(grid, tops, covered, level);
        double sheet = level;
        for (std::size_t c = 0; c < tops.size(); ++c) {
            cut_off[c] = double(wave[c]) + cells[c];
            if (tops[c] > cut_off[c]) sheet = std::max(sheet, static_cast<double>(tops[c]));
        }
        const WaterAbove air = water_above(grid, frame, cut_off);
        const WaterAbove raised = wake.length > 0 ? water_above(grid, frame, wake.cut_off) : WaterAbove{};
        double raw = nan;
        for (int k = grid.nz - 1; k >= 0 && std::isnan(raw); --k) {
            const auto first = frame.water.begin() + static_cast<std::ptrdiff_t>(grid.voxel(0, 0, k));
            const std::uint8_t most = *std::max_element(first, first + static_cast<std::ptrdiff_t>(grid.columns()));
            if (most >= least_share) raw = grid.z_low(k + 1) - level;
        }
        const std::size_t at = table.append(frame.time);
        const std::array<double, 10> row{sheet - level,
                                         air.height(0.95) - level,
                                         air.height(0.99) - level,
                                         air.height(0.999) - level,
                                         factor * air.total,
                                         factor * air.moment(weight, level),
                                         raw,
                                         wake.length > 0 ? factor * raised.total / wake.length : nan,
                                         raised.total > 0 ? raised.moment(1, level) / raised.total : nan,
                                         raised.height(0.9) - level};
        for (std::size_t c = 0; c < row.size(); ++c) table.columns[c].values[at] = row[c];
    }
    return table;
}

std::vector<float> splash_envelope(const RunRecord& record, double from) {
    const RasterGrid grid(record.raster);
    std::vector<float> envelope(grid.empty() ? 0 : grid.columns(), std::numeric_limits<float>::quiet_NaN());
    if (grid.empty()) return envelope;
    const SolidVoxels solid = solid_voxels(record);
    for (const RasterFrame& frame : record.frames) {
        if (frame.time < from) continue;
        const auto tops = sheet_tops(grid, frame, main_body(grid, frame, solid), solid);
        for (std::size_t c = 0; c < tops.size(); ++c)
            if (std::isfinite(tops[c]) && !(envelope[c] >= tops[c])) envelope[c] = tops[c];
    }
    return envelope;
}

WakeWidth wake_width(const RunRecord& record, const std::vector<float>& envelope, double level) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || envelope.empty() || record.hull.points.empty()) return {};
    const double stern = stern_of(record);
    std::vector<int> stations;
    double mean_crest = 0;
    for (int i = 0; i < grid.nx; ++i) {
        if (grid.x(i) <= stern) continue;
        double crest = -std::numeric_limits<double>::infinity();
        for (int j = 0; j < grid.ny; ++j)
            if (std::isfinite(envelope[grid.column(i, j)]))
                crest = std::max(crest, envelope[grid.column(i, j)] - level);
        if (!std::isfinite(crest)) continue;
        stations.push_back(i);
        mean_crest += crest;
    }
    if (stations.empty()) return {};
    mean_crest /= static_cast<double>(stations.size());
    if (mean_crest < 0.5 * grid.spec.voxel) return {};
    const double threshold = level + 0.5 * mean_crest;
    const bool half_model = number_of_text(record, "symmetry_factor", 1) > 1;
    double sum = 0;
    int wide = 0, clipped = 0;
    for (const int i : stations) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int j = 0; j < grid.ny; ++j)
            if (envelope[grid.column(i, j)] >= threshold) {
                low = std::min(low, grid.y(j));
                high = std::max(high, grid.y(j));
            }
        if (high < low) continue;
        sum += half_model ? 2 * (high + 0.5 * grid.spec.voxel) : high - low + grid.spec.voxel;
        ++wide;
        const bool at_low_side = !half_model && low <= grid.y(0);
        if (at_low_side || high >= grid.y(grid.ny - 1)) ++clipped;
    }
    if (wide == 0) return {};
    return {sum / wide, static_cast<double>(clipped) / wide};
}

}  // namespace tw
