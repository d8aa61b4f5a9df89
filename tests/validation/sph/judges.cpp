#include "judges.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "csv.h"

namespace tw::test {
namespace {

/// Elevation of the water at rest [m].
double still_level(const Scene& scene) {
    if (scene.water_blocks.empty()) return 0;
    double top = scene.water_blocks.front().max.z();
    for (const Box& block : scene.water_blocks) top = std::max(top, block.max.z());
    return top;
}

/// Mean over the times from `from` on; a NaN spoils it, and so does an empty window.
double mean(const Table& table, const std::string& name, double from) {
    const Column* column = table.find(name);
    if (!column) return nan;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < table.time.size(); ++i)
        if (table.time[i] >= from && !std::isnan(column->values[i])) {  // NaN: not sampled at this step
            sum += column->values[i];
            ++count;
        }
    return sum / count;
}

/// max() that a NaN spoils.
double largest(double a, double b) { return std::isnan(a) || std::isnan(b) ? nan : std::max(a, b); }

double last_of(const RunRecord& record, const char* name) {
    const Column* column = record.series("samples", name);
    return column && !column->values.empty() ? column->values.back() : nan;
}

void add_particles_lost(std::vector<Row>& rows, const RunRecord& record) {
    if (record.series("samples", "particles_lost"))
        rows.push_back({"particles lost", "", last_of(record, "particles_lost"), 0});
}

struct FrontPoint {
    double time = 0;   ///< t sqrt(2 g / a) [-]
    double place = 0;  ///< x / a [-]
};

/// Farthest place the water on the floor has reached [m]: the end of the unbroken wet run of the two lowest voxel
/// layers (the tongue is a particle or two thick), a partly filled last voxel counted by its share.
double front_on_floor(const RasterSpec& raster, const RasterFrame& frame) {
    const auto [nx, ny, nz] = raster.count;
    double front = raster.origin.x();
    for (int i = 0; i < nx; ++i) {
        double wet = 0;
        for (int k = 0; k < std::min(nz, 2); ++k)
            for (int j = 0; j < ny; ++j)
                wet += frame.water[static_cast<std::size_t>((k * ny + j) * nx + i)] / 255.0 / ny;
        front += std::min(1.0, wet) * raster.voxel;
        if (wet < 0.25) break;
    }
    return front;
}

/// Linear between points; NaN outside.
template <class Times, class Values>
double value_at(const Times& times, const Values& values, double time) {
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    if (after == times.end() || (after == times.begin() && *after != time)) return nan;
    const auto i = static_cast<std::size_t>(after - times.begin());
    if (*after == time) return values[i];
    return values[i - 1] + (values[i] - values[i - 1]) * (time - times[i - 1]) / (times[i] - times[i - 1]);
}

/// Root mean square of run - measured over the measured times the run covers.
double rms(const std::vector<double>& measured_times, const std::vector<double>& measured, const Table& table,
           const Column& column) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < measured_times.size(); ++i) {
        if (measured_times[i] < table.time.front() || measured_times[i] > table.time.back()) continue;
        const double difference = value_at(table.time, column.values, measured_times[i]) - measured[i];
        sum += difference * difference;
        ++count;
    }
    return std::sqrt(sum / count);
}

/// First time a series exceeds `level`.
double arrival(const std::vector<double>& times, const std::vector<double>& values, double level) {
    for (std::size_t i = 0; i < times.size(); ++i)
        if (values[i] > level) return times[i];
    return nan;
}

}  // namespace

bool Row::passes() const { return std::abs(value) <= limit; }

std::vector<Row> judge_still_water(const Scene& scene, const RunRecord& record, double from) {
    std::vector<Row> rows;
    const double dp = scene.resolution.near_hull, level = still_level(scene);
    const Table& height = record.tables.at("height");
    double excursion = height.columns.empty() ? nan : 0;
    for (const Column& probe : height.columns)
        for (const double z : probe.values) excursion = largest(excursion, std::abs(z - level) / dp);
    rows.push_back({"largest excursion of the surface", "dp", excursion, 0.5});

    const Table& pressure = record.tables.at("pressure");
    const double weight = scene.water.density * scene.water.gravity;  // [Pa/m]
    double error = scene.sampling.pressure.empty() ? nan : 0;
    for (const PressureProbe& probe : scene.sampling.pressure) {
        const double exact = weight * (level - probe.place.z());
        error = largest(error, std::abs(mean(pressure, probe.name, from) - exact) / (weight * scene.water.depth));
    }
    rows.push_back({"mean pressure, worst probe", "%", 100 * error, 1});
    add_particles_lost(rows, record);
    return rows;
}

std::vector<Row> judge_buoyancy(const Scene& scene, const RunRecord& record, double from) {
    std::vector<Row> rows;
    const double buoyancy = scene.water.density * scene.water.gravity * scene.hull->still.volume;  // Archimedes [N]
    const Table& forces = record.tables.at("forces");
    rows.push_back({"upward force - rho g V", "%", 100 * (mean(forces, "fz", from) / buoyancy - 1), 0.5});
    rows.push_back({"force along x", "% of rho g V", 100 * mean(forces, "fx", from) / buoyancy, 0.5});
    rows.push_back({"force along y", "% of rho g V", 100 * mean(forces, "fy", from) / buoyancy, 0.5});
    // Two other measures of the same force, which see the same water by other means.
    if (forces.find("fz_surface"))
        rows.push_back(
            {"from the surface pressure - rho g V", "%", 100 * (mean(forces, "fz_surface", from) / buoyancy - 1), 3});
    // The box's floor carries some fourteen times rho g V: one per cent of pressure there is 14 % here (found: 4.7 %).
    if (forces.find("fz_volume"))
        rows.push_back(
            {"from the control volume - rho g V", "%", 100 * (mean(forces, "fz_volume", from) / buoyancy - 1), 8});
    return rows;
}

std::vector<Row> judge_channel(const Scene& scene, const RunRecord& record, double from) {
    std::vector<Row> rows;
    const Table& height = record.tables.at("height");
    double deviation = height.columns.empty() ? nan : 0;
    for (const Column& probe : height.columns)
        deviation = largest(deviation,
                            std::abs(mean(height, probe.name, from) - still_level(scene)) / scene.resolution.near_hull);
    rows.push_back({"mean surface, worst gauge", "dp", deviation, 0.1});
    const Column* mass = record.series("samples", "mass");
    rows.push_back({"drift of the mass", "%", mass ? 100 * (mass->values.back() / mass->values.front() - 1) : nan, 1});
    add_particles_lost(rows, record);
    return rows;
}

namespace {

/// Front of a run, in widths of the column and t sqrt(2 g / a), until it nears the wall.
struct Front {
    std::vector<double> times, places;
    double far = 0;  ///< nine tenths of the way to the wall

    Front(const Scene& scene, const RunRecord& record) {
        const Box& column = scene.water_blocks.at(0);
        const double a = column.size().x();
        far = 0.9 * (scene.domain.box.max.x() - column.min.x()) / a;
        for (const RasterFrame& frame : record.frames) {
            times.push_back(frame.time * std::sqrt(2 * scene.water.gravity / a));
            places.push_back((front_on_floor(record.raster, frame) - column.min.x()) / a);
        }
    }
    /// Mean and largest difference from points that are moved by `later`, from t sqrt(2 g / a) = 1 on [%].
    struct Difference {
        double mean = nan, worst = nan;
        int count = 0;
    };
    Difference from(const std::vector<FrontPoint>& points, double later) const {
        double sum = 0, worst = 0;
        int count = 0;
        for (const FrontPoint& p : points) {
            const double time = p.time + later;
            if (time < 1 || times.empty() || time > times.back() || p.place > far) continue;
            const double difference = 100 * (value_at(times, places, time) / p.place - 1);
            sum += difference, worst = largest(worst, std::abs(difference)), ++count;
        }
        return count >= 3 ? Difference{sum / count, worst, count} : Difference{};
    }
};

}  // namespace

std::vector<Row> judge_dam_break_front(const Scene& scene, const RunRecord& record,
                                       const std::filesystem::path& exact) {
    const Csv csv = read_csv(exact);
    const auto T = csv.numbers("T_t_sqrt_2g_over_a"), x = csv.numbers("x_front_over_a");
    std::vector<FrontPoint> points;
    for (std::size_t i = 0; i < T.size(); ++i) points.push_back({T[i], x[i]});
    const Front::Difference d = Front(scene, record).from(points, 0);
    return {{"front, mean over " + std::to_string(d.count) + " points, boundary elements", "%", d.mean, 1},
            {"front, worst point, boundary elements", "%", d.worst, 2}};
}

std::vector<Row> judge_measured_front(const Scene& scene, const RunRecord& record,
                                      const std::filesystem::path& measured) {
    const Front front(scene, record);
    const Csv csv = read_csv(measured);
    const auto T = csv.numbers("T_sqrt_2g_over_a"), x = csv.numbers("x_over_a");
    std::vector<Row> rows;
    for (const auto& [series, digitised_by] :
         {std::pair<std::string, std::string>{"koshizuka_oka_1996", "DualSPHysics"},
          {"koshizuka_oka_1996", "EtherSPH"},
          {"martin_moyce_1952_a2.25in_n2eq2", "pysph"}}) {
        std::vector<FrontPoint> points;
        for (std::size_t i = 0; i < csv.rows.size(); ++i)
            if (csv.rows[i][0] == series && csv.rows[i][1] == digitised_by) points.push_back({T[i], x[i]});
        double best = 0;  // the time that brings the mean difference nearest to zero
        for (int i = -60; i <= 60; ++i)
            if (std::abs(front.from(points, 0.01 * i).mean) < std::abs(front.from(points, best).mean)) best = 0.01 * i;
        const Front::Difference d = front.from(points, best);
        const std::string who = series + " (" + digitised_by + ")";
        rows.push_back({"measured water starts later by, " + who, "sqrt(a / 2g)", -best, 0.4});
        rows.push_back(
            {"front moved by that, worst of " + std::to_string(d.count) + " points, " + who, "%", d.worst, 10});
    }
    return rows;
}

std::vector<Row> judge_wedge_drop(const Scene& scene, const RunRecord& record, const std::filesystem::path& exact) {
    const MovingBody& wedge = scene.bodies.at(0);
    const Table& t = record.tables.at(body_table(wedge.name));
    const std::vector<double>&z = t.find("z")->values, &vz = t.find("vz")->values;
    // its keel meets the water, z = 0
    const double keel = wedge.surface.bounds().min.z() - wedge.motion.mass.centre.z();
    double met = nan;
    for (std::size_t i = 1; i < z.size() && std::isnan(met); ++i)
        if (z[i] + keel <= 0) met = t.time[i - 1] + (t.time[i] - t.time[i - 1]) * (z[i - 1] + keel) / (z[i - 1] - z[i]);
    const Csv csv = read_csv(exact);
    const auto mass = csv.numbers("mass_kg_per_m"), times = csv.numbers("t_s"),
               speeds = csv.numbers("velocity_m_per_s");
    std::vector<Row> rows;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (std::abs(mass[i] / wedge.motion.mass.mass - 1) > 1e-3) continue;
        if (times[i] < 0.004 || std::fmod(times[i] + 1e-9, 0.005) > 1e-6 || times[i] > 0.026) continue;
        char name[64];
        std::snprintf(name, sizeof name, "speed after %.0f ms (%.2f m/s)", 1000 * times[i], speeds[i]);
        rows.push_back({name, "%", 100 * (-value_at(t.time, vz, met + times[i]) / speeds[i] - 1), 3});
    }
    return rows;
}

std::vector<Row> judge_spheric2(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured) {
    const Csv csv = read_csv(measured);
    const auto times = csv.numbers("t_s");
    std::vector<Row> rows;
    const Table& height = record.tables.at("height");
    for (const HeightProbe& gauge : scene.sampling.height) {
        for (const double x : {0.496, 0.992, 1.488, 2.638}) {
            if (std::abs(gauge.x - x) > 0.01) continue;
            char name[32];
            std::snprintf(name, sizeof name, "h_x%.3f_m", x);
            auto run = *height.find(gauge.name);
            for (double& z : run.values) z -= scene.domain.box.min.z();  // depth over the floor
            rows.push_back({"height at x = " + std::string(name + 3, 5) + " m, rms", "% of the column",
                            100 * rms(times, csv.numbers(name), height, run) / 0.55, 10});
        }
    }
    const Table& pressure = record.tables.at("pressure");
    for (const PressureProbe& probe : scene.sampling.pressure) {
        const Column* run = pressure.find(probe.name);
        const std::string name = probe.name + "_Pa";
        if (!run || std::find(csv.names.begin(), csv.names.end(), name) == csv.names.end()) continue;
        const auto values = csv.numbers(name);
        const double peak = *std::max_element(values.begin(), values.end());
        rows.push_back({probe.name + ", rms", "% of its peak", 100 * rms(times, values, pressure, *run) / peak, 20});
        if (probe.name == "P1")  // lowest on the box: the first to be hit
            rows.push_back({"arrival at the box", "s",
                            arrival(pressure.time, run->values, 0.1 * peak) - arrival(times, values, 0.1 * peak),
                            0.05});
    }
    return rows;
}

std::vector<Row> judge_entry(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured) {
    const MovingBody& body = scene.bodies.at(0);
    const double density = body.motion.mass.mass / mass_properties(body.surface).volume;
    const Table& t = record.tables.at(body_table(body.name));
    std::vector<double> down;
    for (const double z : t.find("z")->values) down.push_back(body.motion.mass.centre.z() - z);
    const Csv csv = read_csv(measured);
    const auto densities = csv.numbers("rho_body_kg_per_m3"), times = csv.numbers("t_s"),
               depths = csv.numbers("penetration_m");
    std::vector<Row> rows;
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
        // Before 5 ms the plotted points are not read well enough.
        if (std::abs(densities[i] / density - 1) > 0.01 || times[i] < 0.005 || times[i] > t.time.back()) continue;
        char name[96];
        std::snprintf(name, sizeof name, "penetration at %.4f s, %s, %.4f m", times[i], csv.rows[i][0].c_str(),
                      depths[i]);
        rows.push_back({name, "%", 100 * (value_at(t.time, down, times[i]) / depths[i] - 1), 10});
    }
    return rows;
}

namespace {

/// An elevation from 8.5 to 11 periods of the motion on.
struct LateWaves {
    double crest = nan, trough = nan;
    std::vector<double> fronts;  ///< times at which it rises through half of the depth, the first of each half period

    LateWaves(const std::vector<double>& periods, const std::vector<double>& elevation, double depth) {
        if (periods.empty() || periods.back() < 10.99) return;
        for (std::size_t i = 1; i < periods.size(); ++i) {
            if (periods[i] < 8.5 || periods[i] > 11) continue;
            if (!(crest >= elevation[i])) crest = elevation[i];
            if (!(trough <= elevation[i])) trough = elevation[i];
            const double below = depth / 2 - elevation[i - 1], rise = elevation[i] - elevation[i - 1];
            if (below <= 0 || elevation[i] < depth / 2) continue;
            const double passes = periods[i - 1] + (periods[i] - periods[i - 1]) * below / rise;
            if (fronts.empty() || passes > fronts.back() + 0.5) fronts.push_back(passes);
        }
    }
    /// By how many periods the front comes later than in `others`, the worst of all; NaN where their number differs.
    double later_than(const LateWaves& others) const {
        if (fronts.empty() || fronts.size() != others.fronts.size()) return nan;
        double worst = 0;
        for (std::size_t i = 0; i < fronts.size(); ++i)
            if (const double later = fronts[i] - others.fronts[i]; std::abs(later) > std::abs(worst)) worst = later;
        return worst;
    }
};

}  // namespace

std::vector<Row> judge_sloshing(const Scene& scene, const RunRecord& record, const std::filesystem::path& shallow_water,
                                const std::filesystem::path& measured) {
    const double period = scene.tank_motion.value().law.period, depth = scene.water.depth;
    const Table& height = record.tables.at("height");
    const std::vector<double>& elevation = height.find(scene.sampling.height.at(0).name)->values;
    std::vector<double> periods;
    for (const double t : height.time) periods.push_back(t / period);
    const Csv exact = read_csv(shallow_water), experiment = read_csv(measured);
    const auto times = experiment.numbers("t_s_as_stored");
    auto heights = experiment.numbers("eta_m_as_stored");
    for (double& h : heights) h -= 0.005;  // its zero is that much too high

    const LateWaves run(periods, elevation, depth),
        theory(exact.numbers("t_over_T"), exact.numbers("elevation_50mm_m"), depth), seen(times, heights, depth);
    double squares = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double d = value_at(periods, elevation, times[i]) - heights[i];
        squares += d * d / double(times.size());
    }
    const auto crest_row = [&](const char* name, const LateWaves& truth, double limit) {
        return Row{name, "%", 100 * (run.crest / truth.crest - 1), limit};
    };
    const auto trough_row = [&](const char* name, const LateWaves& truth) {
        return Row{name, "% of the crest", 100 * (run.trough - truth.trough) / truth.crest, 10};
    };
    return {crest_row("crest, shallow water", theory, 4),
            trough_row("trough, shallow water", theory),
            {"front comes later, worst, shallow water", "periods", run.later_than(theory), 0.02},
            crest_row("crest, measured less 5 mm", seen, 15),
            trough_row("trough, measured less 5 mm", seen),
            {"front comes later, worst, measured", "periods", run.later_than(seen), 0.05},
            {"elevation, measured less 5 mm, rms", "% of the crest", 100 * std::sqrt(squares) / seen.crest, 20}};
}

std::vector<Row> judge_cubes(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured) {
    const MovingBody& body = scene.bodies.at(0);
    const bool falls = body.motion.mass.mass > scene.water.density * mass_properties(body.surface).volume;
    const Table& t = record.tables.at(body_table(body.name));
    std::vector<double> height, times, heights;
    for (const double z : t.find("z")->values) height.push_back(z - scene.domain.box.min.z());
    const Csv csv = read_csv(measured);
    const auto all_times = csv.numbers("t_s"), all_heights = csv.numbers("z_m_as_stored");
    for (std::size_t i = 0; i < csv.rows.size(); ++i)
        if (csv.rows[i][0] == (falls ? "falling" : "floating"))
            times.push_back(all_times[i]), heights.push_back(all_heights[i]);
    const double shift =
        falls ? 0 : times[static_cast<std::size_t>(std::ranges::max_element(heights) - heights.begin())];
    std::vector<Row> rows;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double z = value_at(t.time, height, times[i] - shift);
        if (std::isnan(z)) continue;
        char name[96];
        std::snprintf(name, sizeof name, "height at %.3f s (%.3f s of the run), measured %.1f mm", times[i],
                      times[i] - shift, 1000 * heights[i]);
        rows.push_back({name, "mm", 1000 * (z - heights[i]), 2});
        sum += (z - heights[i]) * (z - heights[i]), ++count;
    }
    rows.push_back({"height, rms", "mm", 1000 * std::sqrt(sum / count), 2});
    return rows;
}

namespace {

/// Mean over whole periods of the largest less the smallest value in each.
double range_of(const std::vector<double>& times, const std::vector<double>& values, double from, double period,
                int periods) {
    double sum = 0;
    for (int k = 0; k < periods; ++k) {
        double low = nan, high = nan;
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (times[i] < from + k * period || times[i] >= from + (k + 1) * period || std::isnan(values[i])) continue;
            if (!(low <= values[i])) low = values[i];
            if (!(high >= values[i])) high = values[i];
        }
        sum += high - low;
    }
    return sum / periods;
}

}  // namespace

std::vector<Row> judge_box_in_waves(const Scene& scene, const RunRecord& record,
                                    const std::filesystem::path& measured) {
    const MotionLaw& piston = scene.bodies.at(0).motion.law.value();
    const double period = piston.period, wave = piston.amplitude > 0.025 ? 0.10 : 0.04;
    const Csv csv = read_csv(measured);
    const auto heights = csv.numbers("wave_height_m"), times = csv.numbers("t_s_arbitrary_origin"),
               values = csv.numbers("value");
    const Table& t = record.tables.at(body_table(scene.bodies.at(1).name));
    const Table& gauge = record.tables.at("height");
    const int periods = 3;
    const double from = t.time.back() - periods * period - 1e-6;
    std::vector<double> pitch;  // about y, in degrees: (q0, qy) of a turn in the plane
    for (std::size_t i = 0; i < t.time.size(); ++i)
        pitch.push_back(2 * std::atan2(t.find("qy")->values[i], t.find("q0")->values[i]) * 180 / std::numbers::pi);
    std::vector<Row> rows;
    for (const auto& [quantity, run_times, run] :
         {std::tuple<std::string, const std::vector<double>&, const std::vector<double>&>{"wavegauge", gauge.time,
                                                                                          gauge.columns.at(0).values},
          {"heave", t.time, t.find("z")->values},
          {"pitch", t.time, pitch},
          {"surge", t.time, t.find("x")->values}}) {
        std::vector<double> ts, xs;
        for (std::size_t i = 0; i < csv.rows.size(); ++i)
            if (csv.rows[i][1] == quantity && std::abs(heights[i] - wave) < 1e-3)
                ts.push_back(times[i]), xs.push_back(values[i]);
        const int all = static_cast<int>((ts.back() - ts.front()) / period);
        const auto drift = [&](const std::vector<double>& time, const std::vector<double>& x, double begin, int n) {
            return (value_at(time, x, begin + n * period) - value_at(time, x, begin)) / (n * period);
        };
        const bool surge = quantity == "surge";
        const double found =
                         surge ? drift(run_times, run, from, periods) : range_of(run_times, run, from, period, periods),
                     truth = surge ? drift(ts, xs, ts.front(), all) : range_of(ts, xs, ts.front(), period, all);
        char name[120];
        std::snprintf(name, sizeof name, "%s, %s: %.4g, measured %.4g %s", quantity.c_str(),
                      surge ? "drift" : "highest to lowest in a period", found, truth,
                      surge                 ? "m/s"
                      : quantity == "pitch" ? "deg"
                                            : "m");
        rows.push_back({name, "%", 100 * (found / truth - 1), 20});
    }
    return rows;
}

}  // namespace tw::test
