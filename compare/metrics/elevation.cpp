#include "compare/metrics/elevation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/splash.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"
#include "statistics/time_bins.h"

namespace tw {

namespace {

std::vector<double> places(const RunRecord& record, const std::string& prefix) {
    std::vector<double> list;
    for (int k = 0;; ++k) {
        const double place = number_of(record, fmt::format("{}_{}", prefix, k), nan);
        if (std::isnan(place)) return list;
        list.push_back(place);
    }
}

/// Value of the map at a place across the cut: linear between the two neighbouring rows of columns; at the edge the
/// last row.
struct Between {
    int low, high;
    double weight;  // of `high`
    Between(double place, double origin, double spacing, int count) {
        const double at = (place - origin) / spacing - 0.5;
        low = std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
        high = std::min(low + 1, count - 1);
        weight = std::clamp(at - low, 0.0, 1.0);
    }
};

Cut cut_through(const RasterGrid& grid, const ElevationMap& map, bool along_x, double place) {
    Cut cut;
    cut.along_x = along_x;
    cut.place = place;
    const Between b = along_x ? Between(place, grid.spec.origin.y(), grid.spec.voxel, grid.ny)
                              : Between(place, grid.spec.origin.x(), grid.spec.voxel, grid.nx);
    for (int i = 0; i < (along_x ? grid.nx : grid.ny); ++i) {
        const std::size_t low = along_x ? grid.column(i, b.low) : grid.column(b.low, i);
        const std::size_t high = along_x ? grid.column(i, b.high) : grid.column(b.high, i);
        const auto mix = [&](const std::vector<float>& v) {
            return b.weight == 0 ? v[low] : (1 - b.weight) * v[low] + b.weight * v[high];
        };
        cut.position.push_back(along_x ? grid.x(i) : grid.y(i));
        cut.elevation.push_back(mix(map.mean));
        cut.deviation.push_back(mix(map.deviation));
    }
    return cut;
}

Extreme extreme(const Cut& cut, double sign) {
    Extreme best{nan, nan, nan};
    for (std::size_t i = 0; i < cut.elevation.size(); ++i)
        if (std::isfinite(cut.elevation[i]) && !(sign * best.value >= sign * cut.elevation[i]))
            best = {cut.elevation[i], cut.deviation[i], cut.position[i]};
    return best;
}

}  // namespace

ElevationMap mean_elevation(const RunRecord& record, double from) {
    ElevationMap map;
    const RasterGrid grid(record.raster);
    if (grid.empty() || record.frames.empty()) return map;
    std::vector<double> sum(grid.columns(), 0.0), squares(grid.columns(), 0.0);
    std::vector<int> count(grid.columns(), 0);
    const SolidVoxels solid = solid_voxels(record);
    for (const RasterFrame& frame : record.frames) {
        if (frame.time < from && &frame != &record.frames.back()) continue;
        ++map.frames;
        const auto height = elevations(grid, frame, main_body(grid, frame, solid), solid);
        for (std::size_t c = 0; c < height.size(); ++c) {
            if (!std::isfinite(height[c])) continue;
            sum[c] += height[c];
            squares[c] += static_cast<double>(height[c]) * height[c];
            ++count[c];
        }
    }
    const auto covered = under_hull(grid, record.hull);
    map.mean.assign(grid.columns(), std::numeric_limits<float>::quiet_NaN());
    map.deviation = map.mean;
    for (std::size_t c = 0; c < grid.columns(); ++c) {
        if (covered[c] || count[c] == 0) continue;
        const double mean = sum[c] / count[c];
        map.mean[c] = static_cast<float>(mean);
        map.deviation[c] = static_cast<float>(std::sqrt(std::max(0.0, squares[c] / count[c] - mean * mean)));
    }
    return map;
}

std::vector<Cut> elevation_cuts(const RunRecord& record, const ElevationMap& map) {
    std::vector<Cut> cuts;
    const RasterGrid grid(record.raster);
    if (grid.empty() || map.mean.empty()) return cuts;
    auto along_y = places(record, "cut_x"), along_x = places(record, "cut_y");
    if (along_x.empty() && along_y.empty() && record.hull.points.empty()) {
        // the middle of the tank, the same at every size; the raster's voxels end elsewhere at each
        const double raster_end = grid.spec.origin.y() + grid.ny * grid.spec.voxel;
        along_x.push_back(0.5 * (number_of(record, "domain_y_min", grid.spec.origin.y()) +
                                 number_of(record, "domain_y_max", raster_end)));
    }
    const auto inside = [&](double place, int axis, int count) {
        const double at = (place - grid.spec.origin[axis]) / grid.spec.voxel;
        return at >= 0 && at <= count;
    };
    for (const double y : along_x)
        if (inside(y, 1, grid.ny)) cuts.push_back(cut_through(grid, map, true, y));
    for (const double x : along_y)
        if (inside(x, 0, grid.nx)) cuts.push_back(cut_through(grid, map, false, x));
    return cuts;
}

Extreme crest(const Cut& cut) { return extreme(cut, 1); }
Extreme trough(const Cut& cut) { return extreme(cut, -1); }

double rms_difference(const Cut& a, const Cut& b) {
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < a.position.size(); ++i) {
        const double d = value_at(b.position, b.elevation, a.position[i]) - a.elevation[i];
        if (!std::isfinite(d)) continue;
        squares += d * d;
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : nan;
}

void add_elevation(Comparison& comparison, const CompareOptions& options) {
    // A source without raster frames (an experiment) has no cuts, wherever it stands in the list.
    const auto with_cuts = std::ranges::find_if(comparison.analyses, [](const Analysis& a) { return !a.cuts.empty(); });
    if (with_cuts == comparison.analyses.end()) return;
    const auto& first = with_cuts->cuts;
    for (std::size_t k = 0; k < first.size(); ++k) {
        const std::string place = fmt::format("{} = {:.4g} m", first[k].along_x ? "y" : "x", first[k].place);
        for (const bool high : {true, false}) {
            Quantity q = new_quantity(
                fmt::format("{}_{}_{:.4g}", high ? "crest" : "trough", first[k].along_x ? "y" : "x", first[k].place),
                fmt::format("{} along {}", high ? "Highest elevation" : "Lowest elevation", place), "m",
                "of the mean free surface (column integral of the connected water) over this cut, outside the hull's "
                "plan "
                "view; no better than half a voxel");
            for (std::size_t s = 0; s < comparison.sources.size(); ++s) {
                const Analysis& a = comparison.analyses[s];
                const RunRecord& record = comparison.sources[s];
                if (k >= a.cuts.size()) {
                    q.values.push_back(value_of_frames(nan, 0, 0, record, "no raster frames"));
                    continue;
                }
                const Extreme e = high ? crest(a.cuts[k]) : trough(a.cuts[k]);
                const auto frames = static_cast<double>(std::ranges::count_if(
                    record.frames, [&](const RasterFrame& f) { return f.time >= a.surface_from; }));
                const double statistical = frames > 1 ? student_t_95(frames - 1) * e.deviation / std::sqrt(frames) : 0;
                q.values.push_back(value_of_frames(e.value, statistical, 0.5 * record.raster.voxel, record,
                                                   "no free surface on this cut"));
                withhold_if_short(q.values.back(), a, record, options);
            }
            q.scale = comparison.sources.front().raster.voxel;  // an elevation near zero is no measure of itself
            judge(q, comparison.names, comparison.agree_within);
            const std::string whole = of_every_pair(comparison.names, [&](std::size_t a, std::size_t b) {
                const auto &A = comparison.analyses[a].cuts, &B = comparison.analyses[b].cuts;
                const double rms = high && k < std::min(A.size(), B.size()) ? rms_difference(A[k], B[k]) : NAN;
                return std::isfinite(rms) ? fmt::format("whole cut: root mean square difference {:.2g} m", rms)
                                          : std::string();
            });
            if (!whole.empty()) q.remark += (q.remark.empty() ? "" : "; ") + whole;
            comparison.quantities.push_back(std::move(q));
        }
    }
}

}  // namespace tw
