#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/gates/gate_list.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/water_kept.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

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

}  // namespace

void add_water_gates(GateList& list) {
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
    if (const auto change = change_of_water_in_box(record))
        list.add("change of the water in the box", "%", 100 * std::abs(change->value), 1,
                 fmt::format("since the means begin, {} at {:.4g} s: a box that fills or empties has no steady mean",
                             change->value < 0 ? "less" : "more", change->time));
    if (const auto openings = throughput(record)) {
        list.add("unexplained change of the number of particles", "-", openings->unaccounted, 0,
                 fmt::format("besides what the openings let in and out, at {:.4g} s", openings->unaccounted_at));
        list.add("inflow less outflow", "% of the inflow", 100 * std::abs(openings->surplus), 1,
                 fmt::format("since the means begin, {} comes in than leaves: the level drifts",
                             openings->surplus > 0 ? "more" : "less"));
    }
    if (const auto level = level_at_inlet(record); level && number_of(record, "depth", 0) > 0)
        list.add("level at the inlet", "% of the depth", 100 * std::abs(level->value) / number_of(record, "depth", 0),
                 1,
                 fmt::format("{:+.3g} m from the still level, mean up to {:.4g} s: the stream is another one than the "
                             "scene's",
                             level->value, level->time));
}

}  // namespace tw
