#include "compare/metrics/wave_peaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "compare/metrics/period_peaks.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/run_up.h"
#include "compare/metrics/sound.h"
#include "compare/metrics/tank_loads.h"
#include "compare/metrics/wave_samples.h"
#include "record/event_threshold.h"
#include "record/hull_motion.h"
#include "record/record_numbers.h"
#include "statistics/time_bins.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr int parts = 40;  ///< of a period, over one of which an acceleration is taken

/// The known values of a column, in the time of the periods and a little about it.
PeakHistory history_of(const RunRecord& r, const std::string& table, const std::string& column, double sign, bool sound,
                       const WavePeriods& p) {
    PeakHistory h;
    const Column* c = r.series(table, column);
    if (!c) return h;
    const double end = p.from + p.count * p.period;
    const std::vector<double>& time = r.tables.at(table).time;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] > p.from - p.period / 4 && time[i] < end + p.period / 4)
            h.t.push_back(time[i]), h.x.push_back(sign * c->values[i]);
    if (sound)
        if (const double shortest = sound_time(r); shortest > 0) h.lasts = lasting(h.t, h.x, shortest);
    return h;
}

/// Filter, or the longest time between samples where that is longer [s].
double window_of(const std::vector<PeakHistory>& histories, double filter) {
    for (const PeakHistory& h : histories)
        for (std::size_t i = 1; i < h.t.size(); ++i) filter = std::max(filter, h.t[i] - h.t[i - 1]);
    return filter;
}

std::set<std::pair<std::string, std::string>> columns_of(const Comparison& c, const std::string& table) {
    std::set<std::pair<std::string, std::string>> columns;  // name, unit
    for (const RunRecord& r : c.sources)
        if (const auto found = r.tables.find(table); found != r.tables.end())
            for (const Column& column : found->second.columns) columns.emplace(column.name, column.unit);
    return columns;
}

void add_probe_peaks(Comparison& comparison, const PeakTime& time) {
    for (const std::string table : {"pressure", "height"})
        for (const auto& [name, unit] : columns_of(comparison, table)) {
            PeakedThing thing{.name = table + ":" + name,
                              .label = fmt::format("{} at {}, peaks", table == "pressure" ? "Pressure" : "Level", name),
                              .unit = unit,
                              .definition = {}};
            for (const RunRecord& r : comparison.sources) {
                thing.histories.push_back(history_of(r, table, name, 1, table == "pressure", time.periods));
                if (!std::isfinite(thing.threshold)) thing.threshold = number_of(r, event_threshold(table, name), NAN);
            }
            if (table == "height" && time.regular && !std::isfinite(thing.threshold)) continue;  // it has its crest
            thing.window =
                window_of(thing.histories, table == "pressure" ? filter_of(comparison.sources, table, name) : 0);
            thing.definition = fmt::format("highest mean over {:.3g} ms in each period", 1e3 * thing.window);
            add_peaks(comparison, thing, time);
        }
}

void add_force_peaks(Comparison& comparison, const PeakTime& time) {
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables)
            if (name.starts_with("body_")) return;  // what moves has accelerations
    const bool oblique =
        std::ranges::any_of(comparison.sources, [](const RunRecord& r) { return number_of(r, "wave_across", 0) != 0; });
    for (const char axis : {'x', 'y', 'z'}) {
        if (axis == 'y' && !oblique) continue;
        const std::string column = fmt::format("f{}", axis);
        PeakedThing thing{.name = fmt::format("force_{}", axis),
                          .label = axis == 'z' ? "Force upward, peaks"
                                   : oblique   ? fmt::format("Force along {}, on the waves' way, peaks", axis)
                                               : "Force along the waves' way, peaks",
                          .unit = {},
                          .definition = {}};
        double largest = 0;
        for (const RunRecord& r : comparison.sources) {
            const double way = axis == 'x'   ? number_of(r, "wave_direction", 1)
                               : axis == 'y' ? number_of(r, "wave_across", 1)
                                             : 1,
                         sign = way < 0 ? -1 : 1;
            const Table* loads = loads_of(r);
            thing.histories.push_back(loads ? history_of(r, loads->name, column, sign, true, time.periods)
                                            : PeakHistory{});
            if (loads) thing.unit = loads->find(column)->unit;
            for (const double x : thing.histories.back().x)
                if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        }
        if (largest == 0) continue;  // nothing stands there
        thing.window = window_of(thing.histories, default_filter);
        thing.definition = fmt::format("highest mean over {:.3g} ms in each period", 1e3 * thing.window);
        add_peaks(comparison, thing, time);
    }
}

/// What moves in one record, and where the end of it is that meets the waves.
struct MovingThing {
    const Table* table = nullptr;
    Vec3 end = Vec3::Zero();  ///< from the centre of mass, as it stands at the start [m]
};
std::optional<MovingThing> moving_in(const RunRecord& r, const std::string& table) {
    const auto found = r.tables.find(table);
    const auto shape = std::ranges::find(r.bodies, table, &BodyShape::table);
    if (found == r.tables.end() || shape == r.bodies.end() || !found->second.find("vz")) return {};
    const Box box = shape->surface.bounds();
    const bool at_low_x = table == hull_motion_table || number_of(r, "wave_direction", 1) > 0;  // a hull's is its bow
    return MovingThing{&found->second, Vec3((at_low_x ? box.min.x() : box.max.x()) - shape->centre.x(), 0, 0)};
}

/// Its velocity upward in each row, at the centre or at its end: vz + (spin x r)_z [m/s].
std::vector<double> velocity_up(const MovingThing& of, bool at_end) {
    const Table& t = *of.table;
    std::vector<double> v = t.find("vz")->values;
    if (!at_end) return v;
    if (const Column* rate = t.find("trim_rate")) {  // of a hull, bow up [deg/s]; its bow is at low x
        for (std::size_t i = 0; i < v.size(); ++i) v[i] -= rate->values[i] * pi / 180 * of.end.x();
        return v;
    }
    const Column *sx = t.find("spin_x"), *sy = t.find("spin_y"),
                 *q[] = {t.find("q0"), t.find("qx"), t.find("qy"), t.find("qz")};
    if (!sy || !std::ranges::all_of(q, [](const Column* c) { return c != nullptr; })) return {};
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Eigen::Quaterniond turn(q[0]->values[i], q[1]->values[i], q[2]->values[i], q[3]->values[i]);
        const Vec3 r = turn * of.end;
        v[i] += (sx ? sx->values[i] * r.y() : 0) - sy->values[i] * r.x();
    }
    return v;
}

/// The velocity's change over a fortieth of the period, which passes the wave's first ten harmonics within a tenth and
/// what is left of slams [m/s2].
PeakHistory acceleration_of(const std::vector<double>& time, const std::vector<double>& velocity,
                            const WavePeriods& p) {
    PeakHistory h;
    const double step = p.period / parts;
    for (int i = 0; i < 4 * parts * p.count; ++i) {
        const double at = p.from + i / 4.0 * step;
        const double a = (value_at(time, velocity, at + step / 2) - value_at(time, velocity, at - step / 2)) / step;
        if (std::isfinite(a)) h.t.push_back(at), h.x.push_back(a);
    }
    return h;
}

void add_acceleration_peaks(Comparison& comparison, const PeakTime& time) {
    std::set<std::string> tables;
    for (const RunRecord& r : comparison.sources)
        for (const BodyShape& shape : r.bodies)
            if (moving_in(r, shape.table)) tables.insert(shape.table);
    for (const std::string& table : tables)
        for (const bool at_end : {false, true}) {
            const bool hull = table == hull_motion_table;
            const std::string name = hull ? "hull" : table.substr(5),
                              kind = at_end ? "acceleration_bow:" : "acceleration_centre:";
            PeakedThing thing{
                .name = kind + name,
                .label = fmt::format("Acceleration of the {}{}",
                                     !at_end ? "centre of mass"
                                     : hull  ? "bow"
                                             : "end that meets the waves",
                                     hull ? "" : ", " + name),
                .unit = "m/s2",
                .definition = fmt::format("highest upward acceleration in each period, over a fortieth of "
                                          "it ({:.3g} s)",
                                          time.periods.period / parts),
                .name_of_mean = kind + name};
            double largest = 0;
            for (const RunRecord& r : comparison.sources) {
                thing.histories.emplace_back();
                const auto moving = moving_in(r, table);
                const std::vector<double> v = moving ? velocity_up(*moving, at_end) : std::vector<double>{};
                if (v.empty()) continue;
                thing.histories.back() = acceleration_of(moving->table->time, v, time.periods);
                for (const double a : thing.histories.back().x) largest = std::max(largest, std::abs(a));
            }
            if (largest > 0) add_peaks(comparison, thing, time);
        }
}

}  // namespace

void add_wave_peaks(Comparison& comparison) {
    const PeakTime time = peak_time(comparison);
    if (time.periods.count < 1) return;
    add_acceleration_peaks(comparison, time);
    add_force_peaks(comparison, time);
    add_probe_peaks(comparison, time);
    add_run_up(comparison, time);
}

}  // namespace tw
