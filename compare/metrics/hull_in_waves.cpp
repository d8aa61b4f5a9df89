#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/verdict/judge.h"
#include "record/hull_motion.h"

namespace tw {
namespace {

using std::numbers::pi;

/// What one record holds of its free hull; the places are those at the start, the hull does not surge.
struct HullTable {
    const Table* table = nullptr;
    Vec3 centre = Vec3::Zero();  ///< of mass [m]
};
std::optional<HullTable> hull_of(const RunRecord& r) {
    const auto table = r.tables.find(hull_motion_table);
    const auto shape = std::ranges::find(r.bodies, std::string(hull_motion_table), &BodyShape::table);
    if (table == r.tables.end() || shape == r.bodies.end()) return {};
    return HullTable{&table->second, shape->centre};
}

/// Lead of a column's first harmonic over the theory's crest at the centre of mass [deg].
MeanValue phase_of(const RunRecord& r, const HullTable& hull, const char* column, const WavePeriods& periods) {
    const Column* c = hull.table->find(column);
    const double k = 2 * pi / number_of(r, "wave_length", NAN);
    if (!c || !std::isfinite(k)) return unknown_value(not_given);
    const PeriodHarmonics found =
        harmonics_of_periods(hull.table->time, periods, [&](std::size_t i) { return c->values[i]; });
    return mean_lead(found, k * along_wave(r, hull.centre.x(), hull.centre.y()), periods);
}

}  // namespace

void add_hull_in_waves(Comparison& comparison, const WavePeriods& periods) {
    std::vector<std::optional<HullTable>> hulls;
    for (const RunRecord& r : comparison.sources) hulls.push_back(hull_of(r));
    if (std::ranges::none_of(hulls, [](const auto& h) { return h.has_value(); })) return;
    const auto add = [&](const char* name, const char* label, const char* unit, const std::string& definition,
                         double scale, auto&& of) {
        Quantity q =
            new_quantity(name, label, unit, fmt::format("{}, mean over {} whole periods", definition, periods.count));
        q.scale = scale;
        for (std::size_t i = 0; i < hulls.size(); ++i)
            q.values.push_back(hulls[i] ? of(comparison.sources[i], *hulls[i]) : unknown_value(not_given));
        beside(q);
        q.judged_in_grid_study = true;
        comparison.quantities.push_back(std::move(q));
    };
    const std::string lead = "lead of its first harmonic over the theory's crest at the centre of mass";
    if (comparison.find("heave_response:hull"))
        add("heave_phase:hull", "Phase of the hull's heave", "deg", lead, 180,
            [&](const RunRecord& r, const HullTable& h) { return phase_of(r, h, "z", periods); });
    if (comparison.find("pitch_response:hull"))
        add("pitch_phase:hull", "Phase of the hull's pitch", "deg", lead + ", bow up", 180,
            [&](const RunRecord& r, const HullTable& h) { return phase_of(r, h, "trim", periods); });
}

}  // namespace tw
