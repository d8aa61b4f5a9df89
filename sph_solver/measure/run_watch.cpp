#include "sph_solver/measure/run_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"

namespace tw {

void RunWatch::after_step(const Simulation& simulation) {
    const Level& water = simulation.level(0);  // whole everywhere
    if (water.count() == 0) {
        const Ledger& l = water.ledger();
        throw RunError(
            fmt::format("no water is left at t = {:.6g} s: {} particles have left through open sides and {} were lost "
                        "on the way; a tank without walls or lid, or a gap in them, lets it go",
                        simulation.time(), l.out, l.lost));
    }
    const LevelSetup& s = water.setup();
    double allowed = simulation.setup().cfl * water.h() / (s.state_equation.c0 + water.extremes().speed);
    for (const auto& effect : water.effects()) allowed = std::min(allowed, effect->largest_step(s, water.h()));
    note_step(simulation.time(), simulation.dt(), allowed);
}

void RunWatch::note_step(double time, double step, double allowed) {
    row_ = step < collapsed * allowed ? row_ + 1 : 0;
    if (row_ < longest_row) return;
    throw RunError(fmt::format(
        "the time step has collapsed to {:.2g} s at t = {:.6g} s, where {:.2g} s would do: the run would not "
        "end; something is accelerated beyond measure, most often a body far lighter than water, or "
        "particles pressed into a corner",
        step, time, allowed));
}

}  // namespace tw
