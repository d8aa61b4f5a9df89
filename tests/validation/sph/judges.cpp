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

std::vector<Row> judge_dam_break_front(const Scene& scene, const RunRecord& record,
                                       const std::filesystem::path& measured) {
    const Box& column = scene.water_blocks.at(0);
    const double a = column.size().x(), wall = (scene.domain.box.max.x() - column.min.x()) / a;
    std::vector<double> times, places;
    for (const RasterFrame& frame : record.frames) {
        times.push_back(frame.time * std::sqrt(2 * scene.water.gravity / a));
        places.push_back((front_on_floor(record.raster, frame) - column.min.x()) / a);
    }
    const Csv csv = read_csv(measured);
    const auto T = csv.numbers("T_sqrt_2g_over_a"), x = csv.numbers("x_over_a");
    std::vector<Row> rows;
    for (const auto& [series, digitised_by] :
         {std::pair<std::string, std::string>{"koshizuka_oka_1996", "DualSPHysics"},
          {"koshizuka_oka_1996", "EtherSPH"},
          {"martin_moyce_1952_a2.25in_n2eq2", "pysph"}}) {
        double sum = 0, worst = 0;
        int count = 0;
        for (std::size_t i = 0; i < csv.rows.size(); ++i) {
            if (csv.rows[i][0] != series || csv.rows[i][1] != digitised_by) continue;
            // Before T = 1 the gate or membrane of the experiments has not quite let go.
            if (T[i] < 1 || T[i] > times.back() || x[i] > 0.9 * wall) continue;
            const double difference = 100 * (value_at(times, places, T[i]) / x[i] - 1);
            sum += difference;
            worst = largest(worst, std::abs(difference));
            ++count;
        }
        const std::string who = series + " (" + digitised_by + ")";
        rows.push_back(
            {"front, mean over " + std::to_string(count) + " points, " + who, "%", count >= 3 ? sum / count : nan, 5});
        rows.push_back({"front, worst point, " + who, "%", count >= 3 ? worst : nan, 10});
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

std::vector<Row> judge_sloshing(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured) {
    const double period = scene.tank_motion.value().law.period;
    const Table& height = record.tables.at("height");
    const Column& run = *height.find(scene.sampling.height.at(0).name);
    const Csv csv = read_csv(measured);
    const auto times = csv.numbers("t_s_as_stored"), values = csv.numbers("eta_m_as_stored");
    const auto [trough, crest] = std::ranges::minmax(values);
    const double front = arrival(times, values, crest / 2);
    const double periods = std::ceil(times.back() - front);  // that the run's end has to hold
    std::vector<double> late_times, late;
    for (std::size_t i = 0; i < height.time.size(); ++i) {
        const double t = height.time[i] / period;
        if (t < height.time.back() / period - periods - 1) continue;
        late_times.push_back(t), late.push_back(run.values[i]);
    }
    const double low = *std::ranges::min_element(late), high = *std::ranges::max_element(late);
    std::size_t before = 0;  // the front is steep: what stands high at the window's begin is not it
    while (before < late.size() && late[before] > 0) ++before;
    const std::vector<double> from_times(late_times.begin() + static_cast<std::ptrdiff_t>(before), late_times.end()),
        from(late.begin() + static_cast<std::ptrdiff_t>(before), late.end());
    const double shift = arrival(from_times, from, crest / 2) - front;
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] + shift < late_times.front() || times[i] + shift > late_times.back()) continue;
        const double d = value_at(late_times, late, times[i] + shift) - values[i];
        squares += d * d, ++count;
    }
    return {{"crest", "%", 100 * (high - crest) / crest, 15},
            {"trough", "% of the crest", 100 * (low - trough) / crest, 10},
            {"elevation, rms", "% of the crest", 100 * std::sqrt(squares / count) / crest, 20}};
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
