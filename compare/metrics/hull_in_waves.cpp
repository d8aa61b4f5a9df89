#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
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
    double centre_x = 0;  ///< of mass [m]
    double bow = 0;       ///< how far it is ahead of the centre of mass [m]
};
std::optional<HullTable> hull_of(const RunRecord& r) {
    const auto table = r.tables.find(hull_motion_table);
    const auto shape = std::ranges::find(r.bodies, std::string(hull_motion_table), &BodyShape::table);
    if (table == r.tables.end() || shape == r.bodies.end()) return {};
    return HullTable{&table->second, shape->centre.x(), shape->centre.x() - shape->surface.bounds().min.x()};
}

/// By how much the first harmonic of a column is before the theory's crest at the centre of mass [deg], (-180, 180]. The
/// crest is at x = 0 at t = 0, and at x after k x / omega.
MeanValue phase_of(const RunRecord& r, const HullTable& hull, const char* column, const WavePeriods& periods) {
    const Column* c = hull.table->find(column);
    const double k = 2 * pi / number_of(r, "wave_length", NAN) * number_of(r, "wave_direction", 1);
    if (!c || !std::isfinite(k)) return unknown_value(not_given);
    std::vector<std::complex<double>> found;
    std::complex<double> all = 0;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const WaveSamples s =
            samples_between(hull.table->time, from, from + periods.period, [&](std::size_t i) { return c->values[i]; });
        if (static_cast<int>(s.t.size()) < fewest_in_a_period) continue;
        found.push_back(first_harmonic(s.t, s.x, 2 * pi / periods.period) * std::polar(1.0, -k * hull.centre_x));
        all += found.back();
    }
    if (std::abs(all) == 0) return unknown_value("it does not move");
    std::vector<double> phases;  // round that of the mean
    for (const auto& one : found) phases.push_back(-180 / pi * (std::arg(all) + std::arg(one / all)));
    return mean_over(phases, periods);
}

/// Highest upward acceleration in each period `ahead` of the centre of mass [m/s2]: the velocity's change over a fortieth
/// of the period, which passes the wave's first ten harmonics within a tenth and what is left of slams.
MeanValue highest_acceleration(const HullTable& hull, double ahead, const WavePeriods& periods) {
    const Column *vz = hull.table->find("vz"), *rate = hull.table->find("trim_rate");
    if (!vz || !rate) return unknown_value(not_given);
    const std::vector<double>& time = hull.table->time;
    const auto velocity = [&](double t) {  // between the rows
        const auto after = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
        const auto at = [&](std::size_t i) { return vz->values[i] + rate->values[i] * pi / 180 * ahead; };
        if (after == 0 || after == time.size()) return NAN + 0.0;
        const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
        return at(after - 1) + share * (at(after) - at(after - 1));
    };
    constexpr int parts = 40;
    const double step = periods.period / parts;
    std::vector<double> highest;
    for (int n = 0; n < periods.count; ++n) {
        double most = -HUGE_VAL;
        for (int i = 0; i < 4 * parts; ++i) {
            const double from = periods.from + n * periods.period + (i / 4.0) * step,
                         a = (velocity(from + step / 2) - velocity(from - step / 2)) / step;
            if (std::isfinite(a)) most = std::max(most, a);
        }
        if (std::isfinite(most)) highest.push_back(most);
    }
    return mean_over(highest, periods);
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
        q.judged_in_ladder = true;
        comparison.quantities.push_back(std::move(q));
    };
    const std::string before = "by how much its first harmonic is before the theory's crest at the centre of mass",
                      highest =
                          fmt::format("highest upward acceleration in each period, over a fortieth of it ({:.3g} s)",
                                      periods.period / 40);
    if (comparison.find("heave_response:hull"))
        add("heave_phase:hull", "Phase of the hull's heave", "deg", before, 180,
            [&](const RunRecord& r, const HullTable& h) { return phase_of(r, h, "z", periods); });
    if (comparison.find("pitch_response:hull"))
        add("pitch_phase:hull", "Phase of the hull's pitch", "deg", before + ", bow up", 180,
            [&](const RunRecord& r, const HullTable& h) { return phase_of(r, h, "trim", periods); });
    add("acceleration_centre:hull", "Acceleration of the centre of mass", "m/s2", highest, 0,
        [&](const RunRecord&, const HullTable& h) { return highest_acceleration(h, 0, periods); });
    add("acceleration_bow:hull", "Acceleration of the bow", "m/s2", highest, 0,
        [&](const RunRecord&, const HullTable& h) { return highest_acceleration(h, h.bow, periods); });
}

}  // namespace tw
