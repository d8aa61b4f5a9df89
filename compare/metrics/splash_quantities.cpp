#include "compare/metrics/splash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/metrics/elevation.h"
#include "compare/metrics/entry.h"
#include "compare/metrics/forces.h"
#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/hull_motion.h"
#include "record/record_numbers.h"
#include "record/solid_at_rest.h"
#include "record/spray_jet.h"
#include "statistics/flow_through.h"

namespace tw {

Analysis analyse(const RunRecord& record) {
    Analysis a;
    a.still_level = still_level(record);
    a.settled_from = number_of(record, "mean_from", 0);
    if (record.frames.empty()) return a;
    // A record that ends before its means begin still shows its last frame.
    const double from = std::min(a.settled_from, record.frames.back().time);
    a.splash = splash_series(record, a.still_level);
    for (const BodyShape& body : record.bodies)
        if (body.table != hull_motion_table && !is_at_rest(body))
            a.entries.push_back(entry_series(record, body, a.still_level));
    // A tank's surface has no mean worth a name: its last frame is shown.
    a.surface_from = is_stream(record) ? from : record.frames.back().time;
    const ElevationMap map = mean_elevation(record, a.surface_from);
    a.mean_elevation = map.mean;
    a.cuts = elevation_cuts(record, map);
    a.envelope = splash_envelope(record, from);
    return a;
}

namespace {

/// No height is better than half a voxel.
void widen_to(MeanValue& value, double floor) {
    if (!value.known || value.half_width >= floor) return;
    value.half_width = floor;
    value.limited_by = fmt::format("the raster ({:.2g} m)", floor);
}

/// Why what the jet throws is not judged: of the runs that know their jet, the one with the fewest spacings across it.
std::string unresolved_jet(const std::vector<RunRecord>& records) {
    std::optional<SprayJet> worst;
    for (const RunRecord& r : records) {
        const SprayJet jet{number_of(r, "jet_thickness", 0), number_of(r, "jet_spacing", 0)};
        if (jet.thickness > 0 && jet.size > 0 && (!worst || jet.across() < worst->across())) worst = jet;
    }
    return worst ? worst->why_not_resolved() : "";
}

/// Largest finite value from `from` on; NaN where there is none.
double largest(const Table& table, const Column& column, double from) {
    double most = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < column.values.size(); ++i)
        if (table.time[i] >= from && !(most >= column.values[i])) most = column.values[i];
    return most;
}

/// Water that reaches the top of what is seen of it, of the raster or of the domain, may have gone higher: of a height
/// within a voxel of there only a lower bound is known. Leaves the value out and says so.
void withhold_if_cut_off(MeanValue& value, double highest, double still_level, const RunRecord& record) {
    const RasterSpec& r = record.raster;
    const double top = std::min(r.origin.z() + r.count[2] * r.voxel, number_of(record, "domain_z_max", HUGE_VAL));
    if (!(highest > 0) || highest < top - still_level - r.voxel) return;
    value = {};
    value.why_not =
        fmt::format("water reaches the top, {:.3g} m above still water, where heights are cut off", top - still_level);
}

}  // namespace

MeanValue value_of_frames(double value, double half_width, double floor, const RunRecord& record,
                          const std::string& why_not) {
    MeanValue m;
    if (!std::isfinite(value)) {
        m.why_not = why_not;
        return m;
    }
    m.known = true;
    m.value = value;
    m.half_width = half_width;
    m.from = number_of(record, "mean_from", 0);
    m.to = record.frames.empty() ? 0 : record.frames.back().time;
    widen_to(m, floor);
    return m;
}

void withhold_if_short(MeanValue& value, const Analysis& analysis, const RunRecord& record,
                       const CompareOptions& options) {
    const double needed = options.fewest_flow_throughs * flow_through_time(record);
    const double window = record.frames.empty() ? 0 : record.frames.back().time - analysis.settled_from;
    // Frames are a sampling interval apart: the last may lie that much before the end.
    const double interval =
        record.frames.size() > 1 ? record.frames.back().time - record.frames[record.frames.size() - 2].time : 0;
    if (!value.known || !is_stream(record) || window + interval >= needed) return;
    value = {};
    value.seconds_needed = needed - window;
    value.why_not =
        fmt::format("record too short: {:.2g} s of settled frames, {:.2g} s needed; about {:.2g} s more is needed",
                    std::max(window, 0.0), needed, value.seconds_needed);
}

namespace {

bool has_frames(const Comparison& c) {
    return std::ranges::any_of(c.sources, [](const RunRecord& r) { return !r.frames.empty(); });
}

enum class SplashKind { integral, height, amount };

/// A quantity of the splash and the column of the splash series that it comes from.
struct SplashMeasure {
    const char *name, *label, *unit, *column, *definition;
    SplashKind kind;
};

constexpr SplashMeasure splash_measures[] = {
    {"splash_raised", "Water raised behind the hull", "m2", "raised_area",
     "wave and splash: water above still water behind the hull, per metre of way, whole hull: its volume in "
     "the raster over the length there",
     SplashKind::integral},
    {"splash_raised_mean", "Mean height of the raised water", "m", "raised_mean",
     "height above still water of the centre of the water raised behind the hull", SplashKind::integral},
    {"splash_raised_p90", "Upper decile of the raised water", "m", "raised_p90",
     "height above still water below which 90 % of the water raised behind the hull lies", SplashKind::integral},
    {"splash_sheet_height", "Splash height (connected sheet)", "m", "sheet_height",
     "height above still water of the highest splash that is connected to the main body: voxels at least "
     "half full, 26 neighbours; splash stands more than a surface "
     "cell above the smooth wave",
     SplashKind::height},
    {"splash_p95", "Splash height, 95 % of airborne water", "m", "p95",
     "height above still water below which 95 % of the airborne water lies", SplashKind::height},
    {"splash_p99", "Splash height, 99 % of airborne water", "m", "p99",
     "height above still water below which 99 % of the airborne water lies", SplashKind::height},
    {"splash_p99_9", "Splash height, 99.9 % of airborne water", "m", "p99_9",
     "height above still water below which 99.9 % of the airborne water lies", SplashKind::height},
    {"airborne_volume", "Airborne water", "m3", "airborne_volume",
     "water more than a surface cell above the smooth wave, attached or not, whole hull", SplashKind::amount},
    {"airborne_energy", "Potential energy of airborne water", "J", "airborne_energy",
     "rho g times the airborne water's volume times height", SplashKind::amount}};

/// In a stream the settled mean of the measure's column; in a tank, whose water does not settle, its largest value.
MeanValue splash_value(const SplashMeasure& m, const RunRecord& record, const Analysis& analysis, bool stream,
                       const CompareOptions& options) {
    const bool height = m.kind == SplashKind::height;
    const double floor = height ? 0.5 * record.raster.voxel : 0;
    const double from = stream || record.hull.points.empty() ? analysis.settled_from : 0;
    MeanValue value;
    const Column* column = analysis.splash.find(m.column);
    if (!column) {
        value.why_not = "no raster frames";
        return value;
    }
    const double highest = largest(analysis.splash, *column, from);
    if (stream) {
        value = settled_mean(analysis.splash.time, column->values, settled_rules(record, options, floor));
        widen_to(value, floor);
        if (!value.known && !(highest > -HUGE_VAL))
            value.why_not = m.kind == SplashKind::integral ? "no water behind a hull" : "no airborne water";
    } else {
        value = value_of_frames(highest, 0, floor, record, "no airborne water");
    }
    if (height) withhold_if_cut_off(value, highest, analysis.still_level, record);
    return value;
}

/// `unresolved`: why what is thrown is not judged; "" where it is.
void add_splash_measure(Comparison& comparison, const SplashMeasure& m, bool stream, const std::string& unresolved,
                        const CompareOptions& options) {
    const bool height = m.kind == SplashKind::height;
    Quantity q = new_quantity(m.name, m.label, m.unit, m.definition);
    for (std::size_t s = 0; s < comparison.sources.size(); ++s)
        q.values.push_back(splash_value(m, comparison.sources[s], comparison.analyses[s], stream, options));
    if (height)
        q.definition +=
            fmt::format("; no better than half a voxel ({:.3g} m)", 0.5 * comparison.sources[0].raster.voxel);
    if (!stream)
        q.definition +=
            "; the largest of the run (without a hull from mean_from on), since a tank's water does not settle";
    if (m.kind != SplashKind::integral) q.not_resolved = q.remark = unresolved;
    // A volume's largest value has no interval that could carry a verdict.
    if (q.not_resolved.empty() && (stream || height))
        judge(q, comparison.names, comparison.agree_within);
    else
        beside(q);
    comparison.quantities.push_back(std::move(q));
}

/// The highest connected water and the highest voxel with any, beside the verdict: one droplet decides them.
void add_highest_water(Comparison& comparison) {
    Quantity envelope =
        new_quantity("splash_envelope", "Splash envelope, highest point", "m",
                     "highest connected water at any time of the settled frames; grows with the length of the record");
    Quantity raw = new_quantity("splash_raw_max", "Highest water of any kind (raw)", "m",
                                "highest voxel with a water share of 1/100 at any time of the settled frames: one "
                                "droplet decides it, so it is shown and not judged");
    for (std::size_t s = 0; s < comparison.sources.size(); ++s) {
        const RunRecord& record = comparison.sources[s];
        const Analysis& a = comparison.analyses[s];
        double highest = std::numeric_limits<double>::quiet_NaN();
        for (const float z : a.envelope)
            if (std::isfinite(z) && !(highest >= z - a.still_level)) highest = z - a.still_level;
        envelope.values.push_back(value_of_frames(highest, 0, 0.5 * record.raster.voxel, record, "no raster frames"));
        withhold_if_cut_off(envelope.values.back(), highest, a.still_level, record);
        const Column* heights = a.splash.find("raw_height");
        const double droplet =
            heights ? largest(a.splash, *heights, a.settled_from) : std::numeric_limits<double>::quiet_NaN();
        raw.values.push_back(value_of_frames(droplet, 0, 0.5 * record.raster.voxel, record, "no raster frames"));
    }
    for (Quantity* q : {&envelope, &raw}) {
        beside(*q);
        comparison.quantities.push_back(std::move(*q));
    }
}

MeanValue wake_value(const RunRecord& record, const Analysis& a, const CompareOptions& options) {
    const double mirrored = number_of_text(record, "symmetry_factor", 1), voxel = record.raster.voxel;
    const WakeWidth found = wake_width(record, a.envelope, a.still_level);
    MeanValue value = value_of_frames(found.mean, 0, mirrored * 0.5 * voxel, record,
                                      record.frames.empty() ? "no raster frames" : "no wake crest above half a voxel");
    withhold_if_short(value, a, record, options);
    if (value.known && found.clipped > 0) {
        value = {};
        value.why_not = fmt::format(
            "over {:.0f} % of its length the wake is as wide as the raster ({:.3g} m), or wider than is seen",
            100 * found.clipped, mirrored * record.raster.count[1] * voxel);
    }
    return value;
}

/// Of a hull that moves.
void add_wake_width(Comparison& comparison, const CompareOptions& options) {
    if (std::ranges::none_of(comparison.sources,
                             [](const RunRecord& r) { return !r.hull.points.empty() && number_of(r, "speed", 0) > 0; }))
        return;
    Quantity wake = new_quantity("wake_width", "Kelvin wake width", "m",
                                 "behind the hull: mean distance between the outermost columns whose envelope reaches "
                                 "half the mean crest height; no better than a voxel");
    for (std::size_t s = 0; s < comparison.sources.size(); ++s)
        wake.values.push_back(wake_value(comparison.sources[s], comparison.analyses[s], options));
    judge(wake, comparison.names, comparison.agree_within);
    comparison.quantities.push_back(std::move(wake));
}

}  // namespace

void add_splash(Comparison& comparison, const CompareOptions& options) {
    if (!has_frames(comparison)) return;
    const bool stream = is_stream(comparison.sources.front());
    const std::string unresolved = stream ? unresolved_jet(comparison.sources) : "";
    for (const SplashMeasure& m : splash_measures)
        if (stream || m.kind != SplashKind::integral) add_splash_measure(comparison, m, stream, unresolved, options);
    add_highest_water(comparison);
    add_wake_width(comparison, options);
}

}  // namespace tw
