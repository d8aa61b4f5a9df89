#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/metrics/wave_without.h"
#include "compare/reference/vertical_cylinder.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

/// Of one component in one record.
struct Force {
    MeanValue amplitude, phase, mean;
};

Force force_in(const RunRecord& r, const std::string& column, const WavePeriods& periods) {
    const Column& force = *r.series("forces", column);
    const PeriodHarmonics found =
        harmonics_of_periods(r.tables.at("forces").time, periods, [&](std::size_t i) { return force.values[i]; });
    std::vector<double> amplitudes;
    for (const auto& one : found)
        if (one) amplitudes.push_back(std::abs(*one));
    return {mean_over(amplitudes, periods), mean_lead(found, 0, periods),
            mean_in_periods(r, "forces", column, periods)};
}

/// The force over the wave at the obstacle's place in the run without it, period by period: how well the wave is made and
/// what it loses on its way are in both. Its lead is that over the crest of that wave there.
void add_forces_over_wave(Comparison& comparison, const std::string& unit, const WavePeriods& periods) {
    std::string obstacle;
    for (const RunRecord& r : comparison.sources)
        if (obstacle.empty()) obstacle = obstacle_left_out(r);
    if (obstacle.empty()) return;
    std::vector<WaveWithout> waves;
    for (const RunRecord& r : comparison.sources) waves.push_back(wave_without(r, obstacle, periods));
    const std::string missing = without_twin(comparison, waves, "obstacle");
    for (const std::string axis : {"x", "z"}) {
        const std::string way = axis == "x" ? "along x" : "upward",
                          over = fmt::format(
                              "the first harmonic of the surface at the place of {} in the run without "
                              "it, period by period, mean over {} whole periods{}",
                              obstacle, periods.count, missing);
        Quantity amplitude = new_quantity("wave_force_over_wave_" + axis,
                                          fmt::format("Wave force {} over the wave without {}", way, obstacle),
                                          unit == "N/m" ? "N/m2" : unit + "/m",
                                          "amplitude of the first harmonic of the force on it over that of " + over),
                 phase = new_quantity("wave_force_lead_" + axis,
                                      fmt::format("Lead of the wave force {} over the wave without {}", way, obstacle),
                                      "deg", "phase of the first harmonic of the force on it before that of " + over);
        for (std::size_t k = 0; k < waves.size(); ++k) {
            const RunRecord& r = comparison.sources[k];
            const Column* force = r.series("forces", "f" + axis);
            if (!force || !waves[k].known) {
                const MeanValue none = unknown_value(force ? "no run without it counts" : not_given);
                amplitude.values.push_back(none), phase.values.push_back(none);
                continue;
            }
            PeriodHarmonics ratios = harmonics_of_periods(r.tables.at("forces").time, periods,
                                                          [&](std::size_t i) { return force->values[i]; });
            std::vector<double> amplitudes;
            for (std::size_t n = 0; n < ratios.size(); ++n) {
                const auto& wave = waves[k].wave[n];
                if (ratios[n] && wave && std::abs(*wave) > 0)
                    amplitudes.push_back(std::abs(*(ratios[n] = *ratios[n] / *wave)));
                else
                    ratios[n].reset();
            }
            amplitude.values.push_back(mean_over(amplitudes, periods));
            phase.values.push_back(mean_lead(ratios, 0, periods));
        }
        phase.scale = 180;
        for (Quantity* q : {&amplitude, &phase}) {
            beside(*q);
            q->judged_in_grid_study = true;
            comparison.quantities.push_back(std::move(*q));
        }
    }
    for (const RunRecord& r : comparison.sources)
        if (const double height = number_of(r, "wave_height", NAN); std::isfinite(height)) {
            add_wave_without(comparison, obstacle, waves, height, periods);
            return;
        }
}

/// Beside the force on an upright cylinder; of one whose axis is in a wall of the tank half of it was solved.
void add_cylinder(Comparison& comparison) {
    for (const RunRecord& r : comparison.sources) {
        const auto cylinder = upright_cylinder(r);
        const WaveAtCylinder wave{number_of(r, "wave_height", NAN) / 2,
                                  2 * std::numbers::pi / number_of(r, "wave_length", NAN), number_of(r, "depth", NAN),
                                  number_of(r, "density", NAN), number_of(r, "gravity", NAN)};
        if (!cylinder || number_of(r, "dimensions", 3) != 3 || r.resolution.empty() ||
            cylinder->high < wave.amplitude || cylinder->low > -0.99 * wave.depth || is_stream(r))
            continue;
        const CylinderForce force = mac_camy_fuchs(wave, cylinder->radius);
        if (!std::isfinite(force.amplitude)) continue;
        const Box& tank = r.resolution.front().box;
        const bool half = std::min(std::abs(tank.min.y() - cylinder->y), std::abs(tank.max.y() - cylinder->y)) <
                          0.01 * cylinder->radius;
        const double way = number_of(r, "wave_direction", 1);
        const auto add = [&](const std::string& quantity, const std::string& unit, double value) {
            if (!comparison.find(quantity)) return;
            Reference reference;
            reference.source = "MacCamy & Fuchs 1954";
            reference.quantity = quantity, reference.unit = unit, reference.value = value;
            reference.remark = fmt::format("linear theory in open water, k a = {:.3g}{}", wave.k * cylinder->radius,
                                           half ? "; of the half that is solved" : "");
            comparison.references.push_back(std::move(reference));
        };
        const double solved = force.amplitude * (half ? 0.5 : 1), against = way > 0 ? 0 : 180;
        const auto degrees = [](double angle) { return std::remainder(angle, 360); };
        const double lead = force.lead * 180 / std::numbers::pi + against;
        add("wave_force_x", "N", solved);
        add("wave_force_phase_x", "deg", degrees(lead - way * wave.k * cylinder->x * 180 / std::numbers::pi));
        add("wave_force_over_wave_x", "N/m", solved / wave.amplitude);
        add("wave_force_lead_x", "deg", degrees(lead));
        return;
    }
}

}  // namespace

void add_wave_forces(Comparison& comparison, const WavePeriods& periods) {
    std::string unit;
    std::vector<std::string> axes = {"x", "z"};
    for (const RunRecord& r : comparison.sources)
        if (number_of(r, "wave_across", 0) != 0) axes = {"x", "y", "z"};
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables) {
            if (name.starts_with("body_")) return;  // what moves has responses
            if (name == "forces" && table.find("fx") && table.find("fz")) unit = table.find("fx")->unit;
        }
    if (unit.empty()) return;
    double largest = 0;
    std::vector<Quantity> found;
    for (const std::string& axis : axes) {
        const std::string way = axis == "z" ? "upward" : "along " + axis,
                          over = fmt::format("first harmonic of the force on all solids {}, mean over {} whole periods",
                                             way, periods.count);
        Quantity amplitude = new_quantity("wave_force_" + axis, "Wave force " + way, unit, "amplitude of the " + over),
                 phase = new_quantity("wave_force_phase_" + axis, "Phase of the wave force " + way, "deg",
                                      (axes.size() == 2 ? "lead over the theory's crest at x = 0; "
                                                        : "lead over the theory's crest at x = y = 0; ") +
                                          over),
                 mean = new_quantity("wave_drift_" + axis, "Mean wave force " + way, unit, "mean over whole periods");
        for (const RunRecord& r : comparison.sources) {
            Force force{unknown_value(not_given), unknown_value(not_given), unknown_value(not_given)};
            if (r.series("forces", "f" + axis)) force = force_in(r, "f" + axis, periods);
            if (force.amplitude.known) largest = std::max(largest, force.amplitude.value);
            amplitude.values.push_back(force.amplitude);
            phase.values.push_back(force.phase);
            mean.values.push_back(force.mean);
        }
        phase.scale = 180;
        found.push_back(std::move(amplitude));
        found.push_back(std::move(phase));
        if (axis != "z") found.push_back(std::move(mean));  // upward it holds the buoyancy
    }
    if (largest == 0) return;  // nothing stands there
    for (Quantity& q : found) {
        beside(q);
        q.judged_in_grid_study = true;
        if (q.name.starts_with("wave_drift_")) q.scale = largest;
        comparison.quantities.push_back(std::move(q));
    }
    add_forces_over_wave(comparison, unit, periods);
    add_cylinder(comparison);
}

}  // namespace tw
