#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/numbers.h"
#include "compare/checks/checks.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/wave_samples.h"
#include "record/raster_grid.h"
#include "record/record_numbers.h"
#include "record/spray_table.h"
#include "statistics/time_bins.h"

namespace tw {
namespace {

constexpr double at_rest_within = 0.005;  ///< of the depth: water that stands so low at the start should rest

/// The room of a tank between two heights.
struct Layer {
    double low, high;  ///< [m]
    double area;       ///< free of solids [m2]; of a section [m2 per metre of span]
};

/// How much of [low, high] lies in [from, to] [m].
double overlap(double low, double high, double from, double to) {
    return std::max(0.0, std::min(high, to) - std::max(low, from));
}

/// The layers of a tank, from its floor up, the uppermost without end. Beyond the raster no solid is known.
std::vector<Layer> layers_of(const RunRecord& record) {
    const auto domain = [&](const char* end) { return number_of(record, std::string("domain_") + end, std::nan("")); };
    const bool section = number_of(record, "dimensions", 3) == 2;
    const double x_min = domain("x_min"), x_max = domain("x_max"), y_min = domain("y_min"), y_max = domain("y_max"),
                 floor = domain("z_min"), across = section ? 1 : y_max - y_min, whole = (x_max - x_min) * across;
    const RasterGrid grid(record.raster);
    const SolidVoxels solid = solid_voxels(record);
    std::vector<Layer> layers;
    double reached = floor;
    if (!solid.empty()) {
        const double voxel = record.raster.voxel, y_low = record.raster.origin.y();
        for (int k = 0; k < grid.nz; ++k) {
            const double low = std::max(reached, grid.z_low(k)), high = grid.z_low(k + 1);
            if (high <= low) continue;
            if (low > reached) layers.push_back({reached, low, whole});
            double taken = 0;
            for (int j = 0; j < grid.ny; ++j)
                for (int i = 0; i < grid.nx; ++i) {
                    const std::uint8_t share = solid[grid.voxel(i, j, k)];
                    if (share == 0) continue;
                    const double along = overlap(grid.x(i) - voxel / 2, grid.x(i) + voxel / 2, x_min, x_max);
                    const double over = section ? 1 : overlap(y_low + j * voxel, y_low + (j + 1) * voxel, y_min, y_max);
                    taken += share / 255.0 * along * over;
                }
            layers.push_back({low, high, std::max(0.0, whole - taken)});
            reached = high;
        }
    }
    layers.push_back({reached, HUGE_VAL, whole});
    return layers;
}

/// The lowest centre of mass of a volume of water in a tank [m].
double lowest_centre(const std::vector<Layer>& layers, double volume) {
    double left = volume, moment = 0;
    for (const Layer& layer : layers) {
        if (!(layer.area > 0)) continue;
        const double height = std::min(layer.high - layer.low, left / layer.area);
        moment += height * layer.area * (layer.low + height / 2);
        left -= height * layer.area;
        if (left <= 0) break;
    }
    return moment / volume;
}

/// The water of a tank at rest, row by row of `samples`.
struct TankWater {
    std::vector<double> time;     ///< [s]
    std::vector<double> mass;     ///< [kg]
    std::vector<double> centre;   ///< z_c [m]
    std::vector<double> lowest;   ///< z_c,min [m]
    std::vector<double> kinetic;  ///< [J]
    double floor = 0, g = 0;      ///< [m], [m/s2]
    double above_floor(std::size_t k) const { return lowest[k] - floor; }
};

std::optional<TankWater> water_of_tank_at_rest(const RunRecord& record) {
    if (text_of(record, "motion") != "none" || record.attributes.contains("tank_moves")) return {};
    const Column *mass = record.series("samples", "mass"), *energy = record.series("samples", "potential_energy"),
                 *kinetic = record.series("samples", "kinetic_energy");
    const double density = number_of(record, "density", 0);
    TankWater water;
    water.g = std::abs(number_of(record, "gravity", 0));
    if (!mass || !energy || !kinetic || !(density > 0) || !(water.g > 0)) return {};
    const std::vector<Layer> layers = layers_of(record);
    water.floor = layers.front().low;
    const double whole = number_of_text(record, "symmetry_factor", 1);
    const std::vector<double>& time = record.tables.at("samples").time;
    for (std::size_t k = 0; k < time.size(); ++k) {
        const double m = mass->values[k], E = energy->values[k];
        if (!std::isfinite(E) || !(m > 0)) continue;
        water.time.push_back(time[k]);
        water.mass.push_back(m);
        water.centre.push_back(E / (m * water.g));
        water.lowest.push_back(lowest_centre(layers, m / density / whole));
        water.kinetic.push_back(kinetic->values[k]);
    }
    if (water.time.empty() || !std::isfinite(water.above_floor(0))) return {};
    return water;
}

/// The last frame before water is seen at the open top of the domain, from where it may leave [s]; infinite where it is
/// not.
double no_water_leaves_until(const RunRecord& record) {
    const RasterSpec& r = record.raster;
    if (r.origin.z() + (r.count[2] + 1) * r.voxel < number_of(record, "domain_z_max", HUGE_VAL)) return HUGE_VAL;
    const auto layer = static_cast<std::ptrdiff_t>(r.count[0]) * r.count[1];
    double before = 0;
    for (const RasterFrame& frame : record.frames) {
        if (std::any_of(frame.water.end() - std::min(layer, std::ssize(frame.water)), frame.water.end(),
                        [](auto water) { return water >= least_share; }))
            return before;
        before = frame.time;
    }
    return HUGE_VAL;
}

/// Of the mass of water `m` [kg] at the times `t` [s], as change_of_water_in_box says it of waves.
Departure change_between_periods(const RunRecord& record, std::vector<double> t, std::vector<double> m) {
    const WavePeriods periods = periods_of(t, t.front(), period_of_waves(record));
    if (periods.count < 2) return {nan, t.back()};
    const double begin = std::max(periods.from, t.front()), at_begin = value_at(t, m, begin);
    const auto before = std::ranges::upper_bound(t, begin) - t.begin();
    t.erase(t.begin(), t.begin() + before), m.erase(m.begin(), m.begin() + before);
    t.insert(t.begin(), begin), m.insert(m.begin(), at_begin);
    const std::vector<double> of_period = time_bins(t, m, static_cast<std::size_t>(periods.count));
    const bool each_like_the_other = number_of(record, "wave_period", 0) > 0;
    const auto span = each_like_the_other ? 1 : std::ssize(of_period) / 2;
    const double first = std::accumulate(of_period.begin(), of_period.begin() + span, 0.0),
                 last = std::accumulate(of_period.end() - span, of_period.end(), 0.0);
    return {last / first - 1, t.back()};
}

/// Adds the check of the water in the box; of waves that are too short to judge a warning that says so.
void add_change_in_box(CheckList& list, const Departure& change) {
    const char* const name = "change of the water in the box";
    const double period = period_of_waves(list.record), limit = 1;
    if (std::isnan(change.value)) {
        list.checks.push_back(
            {name, list.name, "%", change.value, limit, false,
             fmt::format("not judged: fewer than two whole wave periods of {:.4g} s are recorded since "
                         "the means begin",
                         period),
             true});
        return;
    }
    const char* const sign = change.value < 0 ? "less" : "more";
    const std::string where = period > 0 ? fmt::format("{} in the mean over the last waves than over the first", sign)
                                         : fmt::format("{} at {:.4g} s", sign, change.time);
    list.add(name, "%", 100 * std::abs(change.value), limit,
             fmt::format("since the means begin, {}: a box that fills or empties has no steady mean", where));
}

}  // namespace

std::optional<Departure> sunk_below_rest(const RunRecord& record) {
    const std::optional<TankWater> water = water_of_tank_at_rest(record);
    std::optional<Departure> worst;
    for (std::size_t k = 0; water && k < water->time.size(); ++k) {
        const double share = (water->lowest[k] - water->centre[k]) / water->above_floor(k);
        if (!worst || share > worst->value) worst = Departure{share, water->time[k]};
    }
    return worst;
}

std::optional<Departure> motion_at_rest(const RunRecord& record) {
    if (has_moving_bodies(record) || number_of(record, "wave_period", 0) > 0) return {};
    const std::optional<TankWater> water = water_of_tank_at_rest(record);
    if (!water || std::abs(water->centre[0] - water->lowest[0]) > at_rest_within * water->above_floor(0)) return {};
    std::optional<Departure> worst;
    for (std::size_t k = 0; k < water->time.size(); ++k) {
        const double share = water->kinetic[k] / (water->mass[k] * water->g * water->above_floor(k));
        if (!worst || share > worst->value) worst = Departure{share, water->time[k]};
    }
    return worst;
}

std::optional<Departure> change_of_water_in_box(const RunRecord& record) {
    const Column* mass = record.series("samples", "mass");
    if (!mass || !(number_of(record, "speed", 0) > 0)) return {};
    const double from = number_of(record, "mean_from", 0);
    const std::vector<double>& time = record.tables.at("samples").time;
    std::vector<double> t, m;
    for (std::size_t k = 0; k < time.size(); ++k)
        if (time[k] >= from && mass->values[k] > 0) t.push_back(time[k]), m.push_back(mass->values[k]);
    if (t.empty()) return {};
    if (period_of_waves(record) > 0) return change_between_periods(record, t, m);
    const auto change = [&](double at_row) { return at_row / m.front() - 1; };
    const auto worst = std::ranges::max_element(m, {}, [&](double at_row) { return std::abs(change(at_row)); });
    return Departure{change(*worst), t[static_cast<std::size_t>(worst - m.begin())]};
}

std::optional<Throughput> throughput(const RunRecord& record) {
    const Column *count = record.series("samples", "particles"), *in = record.series("samples", "particles_in"),
                 *out = record.series("samples", "particles_out");
    if (!count || !in || !out || !(number_of(record, "speed", 0) > 0)) return {};
    if (record.tables.contains(level_table(0)) || record.tables.contains(spray_table)) return {};
    const std::vector<double>& time = record.tables.at("samples").time;
    Throughput t;
    for (std::size_t k = 0; k < time.size(); ++k) {
        const double by_openings = (in->values[k] - in->values[0]) - (out->values[k] - out->values[0]),
                     missing = std::abs(count->values[k] - count->values[0] - by_openings);
        if (missing > t.unaccounted) t.unaccounted = missing, t.unaccounted_at = time[k];
    }
    double from = number_of(record, "mean_from", 0);
    if (const double period = period_of_waves(record); period > 0) {
        const WavePeriods periods = periods_of(time, from, period);
        if (periods.count < 1) return t;
        from = periods.from;
    }
    const auto since = [&](const Column* through) {
        return through->values.back() - value_at(time, through->values, std::clamp(from, time.front(), time.back()));
    };
    if (const double inflow = since(in); inflow > 0) t.surplus = (inflow - since(out)) / inflow;
    return t;
}

std::optional<Departure> level_at_inlet(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || !(number_of(record, "speed", 0) > 0)) return {};
    // Under a wave a mean over voxels is off by half of one: -7.7 mm where gauges have -1.5 mm (voxels of 12.5 mm).
    if (number_of(record, "wave_period", 0) > 0) return {};
    // the raster begins where the stream is undisturbed: behind the zone that absorbs waves at the inlet
    const double inlet = number_of(record, "undamped_x_min", number_of(record, "domain_x_min", std::nan("")));
    if (!(grid.x(0) - record.raster.voxel < inlet + record.raster.voxel)) return {};  // begins farther down the stream
    const SolidVoxels solid = solid_voxels(record);
    const int last = std::max(1, grid.nx / 10);
    double sum = 0, end = 0;
    std::int64_t count = 0;
    for (const RasterFrame& frame : record.frames) {
        if (frame.time < number_of(record, "mean_from", 0)) continue;
        const std::vector<float> heights = elevations(grid, frame, main_body(grid, frame, solid), solid);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < last; ++i)
                if (const float z = heights[grid.column(i, j)]; std::isfinite(z)) sum += double(z), ++count;
        end = frame.time;
    }
    if (count == 0) return {};
    return Departure{sum / static_cast<double>(count), end};
}

void add_water_checks(CheckList& list) {
    const RunRecord& record = list.record;
    if (const Column* mass = record.series("samples", "mass"); mass && !(number_of(record, "speed", 0) > 0)) {
        const double leaves = no_water_leaves_until(record);
        const std::vector<double>& time = record.tables.at("samples").time;
        std::vector<double> known;
        for (std::size_t i = 0; i < mass->values.size(); ++i)
            if (time[i] <= leaves && std::isfinite(mass->values[i])) known.push_back(mass->values[i]);
        if (known.size() > 1 && known.front() > 0)
            list.add("mass drift", "%", 100 * std::abs(known.back() / known.front() - 1), 1,
                     "the water of a tank is conserved" +
                         (std::isfinite(leaves) ? fmt::format(" until it is at the tank's open top, {:.3g} s", leaves)
                                                : ""));
    }
    if (const auto sunk = sunk_below_rest(record))
        list.add(
            "water below the level of its volume", "%", 100 * std::max(0.0, sunk->value), 1,
            fmt::format("no water of constant density can be lower than at rest: volume is missing, worst at {:.4g} s; "
                        "levels, pressures and forces are wrong by as much",
                        sunk->time));
    if (const auto motion = motion_at_rest(record))
        list.add(
            "motion of water at rest", "%", 100 * motion->value, 0.1,
            fmt::format(
                "of the water's energy above the floor, worst at {:.4g} s: nothing in this scene sets it in motion",
                motion->time));
    if (const auto change = change_of_water_in_box(record)) add_change_in_box(list, *change);
    if (const auto openings = throughput(record)) {
        list.add("unexplained change of the number of particles", "-", openings->unaccounted, 0,
                 fmt::format("besides what the openings let in and out, at {:.4g} s", openings->unaccounted_at));
        if (openings->surplus)
            list.add("inflow less outflow", "% of the inflow", 100 * std::abs(*openings->surplus), 1,
                     fmt::format("{}, {} comes in than leaves: the level drifts",
                                 period_of_waves(record) > 0 ? "over the last whole waves" : "since the means begin",
                                 *openings->surplus > 0 ? "more" : "less"));
    }
    if (const auto level = level_at_inlet(record); level && number_of(record, "depth", 0) > 0)
        list.add("level at the inlet", "% of the depth", 100 * std::abs(level->value) / number_of(record, "depth", 0),
                 1,
                 fmt::format("{:+.3g} m from the still level, mean up to {:.4g} s: the run does not hold the level of "
                             "the scene's stream",
                             level->value, level->time));
}

}  // namespace tw
