#include "compare/metrics/run_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "compare/metrics/probes.h"
#include "compare/metrics/raster_columns.h"
#include "compare/reference/run_up_formulas.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

constexpr std::string_view crest_of = "slope_crest_";

/// Top of what is solid in each column of one row, from the floor [m].
std::vector<double> grounds(const RasterGrid& grid, const SolidVoxels& solid, int row) {
    std::vector<double> ground(static_cast<std::size_t>(grid.nx), grid.spec.origin.z());
    if (solid.empty()) return ground;
    for (int i = 0; i < grid.nx; ++i)
        for (int k = 0; k < grid.nz && solid[grid.voxel(i, row, k)] > 0; ++k)
            ground[static_cast<std::size_t>(i)] += grid.spec.voxel * solid[grid.voxel(i, row, k)] / 255.0;
    return ground;
}

/// The columns from the sea to the crest of an obstacle, in the way that the waves run.
std::vector<int> columns_up(const RasterGrid& grid, const std::vector<double>& ground, double from, double to,
                            double crest) {
    const int step = to > from ? 1 : -1;
    const auto column = [&](double x) {
        return std::clamp(static_cast<int>(std::floor((x - grid.spec.origin.x()) / grid.spec.voxel)), 0, grid.nx - 1);
    };
    std::vector<int> columns;
    for (int i = std::clamp(column(from) - step, 0, grid.nx - 1); i >= 0 && i < grid.nx; i += step) {
        columns.push_back(i);
        const bool on_crest = ground[static_cast<std::size_t>(i)] > crest - 0.25 * grid.spec.voxel;
        if (on_crest || i == column(to)) break;
    }
    return columns;
}

double first_known(const Comparison& comparison, const std::string& name) {
    for (const RunRecord& r : comparison.sources)
        if (const double known = number_of(r, name, NAN); std::isfinite(known)) return known;
    return NAN;
}

void add_formulas(Comparison& comparison, const std::string& obstacle, const PeakTime& time) {
    const auto add = [&](const std::string& quantity, const char* source, const RunUp& formula,
                         const std::string& remark) {
        Reference r;
        r.quantity = quantity, r.unit = "m", r.source = source;
        r.value = formula.height, r.half_width = formula.half_width;
        r.in_range = formula.in_range;
        r.remark = remark + (formula.in_range ? "" : "; outside the formula's range: a hint at most");
        comparison.references.push_back(r);
    };
    WavesOnSlope waves{.period = time.periods.period,
                       .depth = first_known(comparison, "slope_depth_" + obstacle),
                       .cot_slope = first_known(comparison, "slope_cot_" + obstacle),
                       .gravity = first_known(comparison, "gravity")};
    if (!time.regular) {
        waves.height = first_known(comparison, "sea_significant_height");
        waves.period /= 1.1;  // Tp over Tm-1,0 of a sea with one peak
        const std::string quantity = "peak_p98:run_up:" + obstacle;
        if (const auto formula = eurotop_run_up(waves); formula && comparison.find(quantity))
            add(quantity, "EurOtop 2018", *formula,
                fmt::format("breaker parameter {:.3g}; ± is 1.96 standard deviations of its coefficients",
                            breaker_parameter(waves)));
        return;
    }
    waves.height = first_known(comparison, "wave_height"), waves.length = first_known(comparison, "wave_length");
    if (const auto measured = ahrens_titus_run_up(waves))
        add("run_up:" + obstacle, "Ahrens & Titus 1985", *measured,
            fmt::format("breaker parameter {:.3g}, a fit to measurements whose scatter is not known here",
                        breaker_parameter(waves)));
    if (const auto linear = long_wave_run_up(waves); linear && first_known(comparison, "slope_plane_" + obstacle) == 1)
        add("run_up:" + obstacle, "Keller & Keller 1964", *linear,
            fmt::format("linear long waves on a plane slope; k d = {:.2g}, R omega^2 / (g tan^2) = {:.2g}",
                        2 * std::numbers::pi / waves.length * waves.depth, steepness_of_run_up(waves, linear->height)));
}

}  // namespace

PeakHistory waterline_on(const RunRecord& record, const std::string& obstacle, const WavePeriods& time) {
    PeakHistory h;
    const RasterGrid grid(record.raster);
    const double crest = number_of(record, std::string(crest_of) + obstacle, NAN),
                 low = number_of(record, "obstacle_x_min_" + obstacle, NAN),
                 high = number_of(record, "obstacle_x_max_" + obstacle, NAN);
    if (grid.empty() || !std::isfinite(crest) || !std::isfinite(low) || !std::isfinite(high)) return h;
    const bool forward = number_of(record, "wave_direction", 1) > 0;
    const SolidVoxels solid = solid_voxels(record);
    std::vector<std::vector<int>> rows;
    for (int j = 0; j < grid.ny; ++j)
        rows.push_back(columns_up(grid, grounds(grid, solid, j), forward ? low : high, forward ? high : low, crest));
    const double end = time.from + time.count * time.period;
    for (const RasterFrame& frame : record.frames) {
        if (frame.time < time.from - 1e-9 * time.period || frame.time > end + 1e-9 * time.period) continue;
        const std::vector<float> tops = sheet_tops(grid, frame, main_body(grid, frame, solid), solid);
        double highest = -HUGE_VAL;
        for (int j = 0; j < grid.ny; ++j) {
            double top = NAN;
            for (const int i : rows[static_cast<std::size_t>(j)]) {
                const double here = tops[grid.column(i, j)];
                if (!std::isfinite(here)) break;
                top = here;
            }
            if (std::isfinite(top)) highest = std::max(highest, top);
        }
        if (std::isfinite(highest)) h.t.push_back(frame.time), h.x.push_back(highest);
    }
    return h;
}

void add_run_up(Comparison& comparison, const PeakTime& time) {
    std::set<std::string> obstacles;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, value] : r.numbers)
            if (name.starts_with(crest_of)) obstacles.insert(name.substr(crest_of.size()));
    for (const std::string& obstacle : obstacles) {
        PeakedThing thing{.name = "run_up:" + obstacle,
                          .label = "Run-up on " + obstacle,
                          .unit = "m",
                          .definition = "highest waterline on its face in each period, above still water",
                          .name_of_mean = "run_up:" + obstacle,
                          .percentiles = {50, 90, 98}};
        for (const RunRecord& r : comparison.sources)
            thing.histories.push_back(waterline_on(r, obstacle, time.periods));
        const std::size_t first = comparison.quantities.size();
        add_peaks(comparison, thing, time);
        for (std::size_t k = first; k < comparison.quantities.size(); ++k)
            for (std::size_t s = 0; s < comparison.sources.size(); ++s)
                set_reading(comparison.quantities[k].values[s], reading_of_height(comparison.sources[s]), of_height);
        add_formulas(comparison, obstacle, time);
    }
}

}  // namespace tw
