#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/metrics/wave_without.h"
#include "compare/verdict/judge.h"
#include "record/hull_motion.h"

namespace tw {
namespace {

using std::numbers::pi;

/// Amplitude of the first harmonic of a series in each period; none where it has too few samples.
using Amplitudes = std::vector<std::optional<double>>;
Amplitudes amplitudes_of(const PeriodHarmonics& harmonics) {
    Amplitudes found;
    for (const auto& one : harmonics) found.push_back(one ? std::optional(std::abs(*one)) : std::nullopt);
    return found;
}

MeanValue mean_ratio(const Amplitudes& of, const Amplitudes& over, double factor, const WavePeriods& periods) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < of.size(); ++k)
        if (of[k] && over[k] && *over[k] > 0) ratios.push_back(*of[k] / *over[k] * factor);
    return mean_over(ratios, periods);
}

/// What moves in the wave: a free body, or the hull that is free in heave and pitch.
struct Mover {
    std::string name, table;
    bool is_hull() const { return table == hull_motion_table; }
    std::string in_words() const { return is_hull() ? "the hull" : name; }
};
std::vector<Mover> movers_of(const Comparison& comparison) {
    std::vector<Mover> movers;
    const auto add = [&](Mover m) {
        if (std::ranges::find(movers, m.table, &Mover::table) == movers.end()) movers.push_back(std::move(m));
    };
    for (const RunRecord& r : comparison.sources)
        for (const auto& [table, of] : r.tables) {
            if (table.starts_with("body_")) add({table.substr(5), table});
            if (table == hull_motion_table) add({"hull", table});
        }
    std::ranges::sort(movers, {}, &Mover::name);
    return movers;
}

/// What one record tells of a body.
struct BodyInWave {
    Amplitudes heave, pitch;  ///< [m], [rad]
};
BodyInWave body_in(const RunRecord& r, const Mover& mover, const WavePeriods& periods) {
    BodyInWave b;
    const auto table = r.tables.find(mover.table);
    if (table != r.tables.end()) {
        const Table& t = table->second;
        const Column *z = t.find("z"), *trim = t.find("trim"), *q0 = t.find("q0"), *qy = t.find("qy");
        if (z && (trim || (q0 && qy))) {
            b.heave = amplitudes_of(harmonics_of_periods(t.time, periods, [&](std::size_t i) { return z->values[i]; }));
            b.pitch = amplitudes_of(harmonics_of_periods(t.time, periods, [&](std::size_t i) {
                return trim ? trim->values[i] * pi / 180 : 2 * std::atan2(qy->values[i], q0->values[i]);
            }));
        }
    }
    return b;
}

}  // namespace

void add_wave_responses(Comparison& comparison, const WavePeriods& periods) {
    double height = NAN, length = NAN;
    for (const RunRecord& r : comparison.sources)
        if (!std::isfinite(height))
            height = number_of(r, "wave_height", NAN), length = number_of(r, "wave_length", NAN);
    if (!(height > 0) || !(length > 0)) return;
    const Amplitudes asked(static_cast<std::size_t>(periods.count), height / 2);
    for (const Mover& mover : movers_of(comparison)) {
        const std::string &name = mover.name, words_of = mover.in_words();
        std::vector<BodyInWave> bodies;
        std::vector<WaveWithout> waves;
        bool any_twin = false, any_response = false;
        for (const RunRecord& r : comparison.sources) {
            bodies.push_back(body_in(r, mover, periods));
            waves.push_back(wave_without(r, name, periods));
            any_twin |= waves.back().known;
        }
        const std::string missing = mover.is_hull() ? "" : without_twin(comparison, waves, "body");
        for (const bool heave : {true, false}) {
            const std::string motion = heave ? "heave" : "pitch", label = heave ? "Heave" : "Pitch";
            const double factor = heave ? 1 : length / (2 * pi);  // over the slope k a
            const auto add = [&](const std::string& quantity, const std::string& words, const std::string& over,
                                 bool of_twin) {
                Quantity q = new_quantity(
                    fmt::format("{}_{}:{}", motion, quantity, name), fmt::format("{} {}", label, words), "-",
                    fmt::format("amplitude of the first harmonic over {}, mean over {} whole periods{}", over,
                                periods.count, missing));
                double largest = 0;
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    const Amplitudes& of = heave ? bodies[i].heave : bodies[i].pitch;
                    if (of.empty())
                        q.values.push_back(unknown_value(not_given));
                    else if (of_twin && !waves[i].known)
                        q.values.push_back(unknown_value("no run without the body counts"));
                    else
                        q.values.push_back(
                            mean_ratio(of, of_twin ? amplitudes_of(waves[i].wave) : asked, factor, periods));
                    if (q.values.back().known) largest = std::max(largest, q.values.back().value);
                }
                if (largest < 1e-6) return;  // it is not free to
                any_response = true;
                beside(q);
                q.judged_in_grid_study = true;
                comparison.quantities.push_back(std::move(q));
            };
            if (any_twin)
                add("over_wave", fmt::format("of {} over the wave without it", words_of),
                    heave ? "that of the surface at its place in the run without the body, period by period"
                          : "the slope k a of the surface at its place in the run without the body, period by period",
                    true);
            add("response", fmt::format("of {} over the wave asked for", words_of),
                heave ? "half the wave height that the scene asks for (what the wave loses on its way is part of the "
                        "response)"
                      : "the slope pi H / L of the wave that the scene asks for (what the wave loses on its way is "
                        "part of the response)",
                false);
        }
        if (any_twin && any_response) add_wave_without(comparison, name, waves, height, periods);
    }
}

}  // namespace tw
