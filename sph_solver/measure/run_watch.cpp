#include "sph_solver/measure/run_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "record/recorded_checks.h"

namespace tw {

void RunWatch::after_step(const Simulation& simulation) {
    const Level& water = simulation.level(0);  // whole everywhere
    if (water.fields().count() == 0) {
        const Ledger& l = water.system().ledger;
        throw RunError(
            fmt::format("no water is left at t = {:.6g} s: {} particles have left through open sides and {} were lost "
                        "on the way; a tank without walls or lid, or a gap in them, lets it escape",
                        simulation.time(), l.out, l.lost));
    }
    const LevelSetup& s = water.system().setup;
    double allowed = simulation.setup().cfl * water.system().h / (s.state_equation.c0 + water.system().extremes.speed);
    for (const auto& effect : water.system().effects)
        allowed = std::min(allowed, effect->largest_step(s, water.system().h));
    note_step(simulation.time(), simulation.dt(), allowed);
}

void RunWatch::note_step(double time, double step, double allowed) {
    row_ = step < collapsed * allowed ? row_ + 1 : 0;
    if (row_ >= longest_row)
        throw RunError(fmt::format(
            "the time step has collapsed to {:.2g} s at t = {:.6g} s, where {:.2g} s would do: the run would not "
            "end; something is accelerated beyond measure, most often a body far lighter than water, or "
            "particles pressed into a corner",
            step, time, allowed));
    if (steps_ == 0) first_step_ = step;
    ++steps_;
    const double expected = std::max(expected_.steps, first_step_ > 0 ? expected_.duration / first_step_ : 0);
    if (expected_.duration > 0 && steps_ > most_steps * expected)
        throw RunError(fmt::format(
            "{:.3g} steps have been taken by t = {:.6g} s since the run was started, and {:.3g} were expected for all "
            "of its {:.6g} s: the step is held down to {:.2g} s, where sound allows {:.2g} s; often a body far lighter "
            "than water or a wall that moves too fast. If this is meant, --resume continues for as many steps again",
            steps_, time, expected, expected_.duration, step, allowed));
}

void RunWatch::after_frame(const RunRecord& record) const {
    const Column *mass = record.series("samples", "mass"), *kinetic = record.series("samples", "kinetic_energy");
    if (!mass || !kinetic || mass->values.empty() || kinetic->values.empty()) return;
    const double time = record.tables.at("samples").time.back(), water = mass->values.back();
    if (water > most_water * mass->values.front())
        throw RunError(fmt::format(
            "there are {:.4g} kg of water at t = {:.6g} s, and at the start there were {:.4g} kg: more comes "
            "in than leaves, often because the outlet lies in the wake or a hull fills most of the box",
            water, time, mass->values.front()));
    const double v2 = expected_.speed * expected_.speed;
    if (!(v2 > 0)) return;
    const char* const cause =
        "the run has become unstable, often by a body far lighter than water, by water caught between walls, or by a "
        "sound speed or time step of one's own; the validity checks in the record (table certificate) say where";
    if (const std::optional<double> made = energy_made(record); made && !(*made <= water * v2 / 4))
        throw RunError(fmt::format(
            "{:.4g} J more are in the water at t = {:.6g} s than anything has given it, and a fall with the "
            "{:.4g} m/s that the scene explains would give {:.4g} J: {}",
            *made, time, expected_.speed, water * v2 / 2, cause));
    if (const double k = kinetic->values.back(); !(k <= 2 * water * v2))
        throw RunError(
            fmt::format("the water moves with {:.4g} J at t = {:.6g} s, as if all of it had {:.4g} m/s, and the scene "
                        "explains {:.4g} m/s: {}",
                        k, time, std::sqrt(2 * k / water), expected_.speed, cause));
}

}  // namespace tw
