#include "sph_solver/measure/validity_checks.h"

#include <algorithm>
#include <limits>

#include "record/recorded_checks.h"
#include "sph_solver/air.h"
#include "sph_solver/measure/level_ledger.h"

namespace tw {

namespace {

void watch_edges(double t, const std::vector<LevelLedger>& sizes, RunRecord& record) {
    for (std::size_t k = 1; k < sizes.size(); ++k) {
        const LevelLedger &coarse = sizes[k - 1], &fine = sizes[k];
        const auto dependent = double(fine.buffers + coarse.overlap + coarse.slaves);
        note_worst(record, {orphans_line, "%", dependent > 0 ? 100 * double(fine.edge.orphans) / dependent : 0, 1, t});
    }
}

}  // namespace

void watch_stability(const Simulation& simulation, RunRecord& record) {
    watch_stability(simulation,
                    simulation.refinements().empty() ? std::vector<LevelLedger>() : level_ledgers(simulation), record);
}

void watch_stability(const Simulation& simulation, const std::vector<LevelLedger>& sizes, RunRecord& record) {
    const LevelSetup& setup = simulation.setup();
    const double t = simulation.time(), c0 = setup.state_equation.c0, percent = 100 / setup.rho0;
    const Vec3 nowhere = RecordedCheck{}.place;
    double held_down = std::numeric_limits<double>::infinity(), lost = 0;
    for (const auto& level : simulation.levels()) {
        const double c = level->system().setup.state_equation.c0 + level->system().extremes.speed;
        const double acoustic = simulation.setup().cfl * level->system().h / c;
        held_down = std::min(held_down, level->system().dt > 0 ? acoustic / level->system().dt : 0);
        lost += static_cast<double>(level->system().ledger.lost);
    }
    const double deviation = 100 * largest_density_deviation;
    for (const auto& level : simulation.water()) {
        const Extremes& e = level->system().extremes;
        note_worst(record, {"Mach number", "-", e.speed / c0, trusted_mach, t, e.fastest_place});
        note_worst(record, {"compression", "%", percent * e.density_deviation_high, 100 * trusted_compression, t,
                            e.densest_place});
        note_worst(record, {"rarefaction", "%", -percent * e.density_deviation_low, deviation, t, e.thinnest_place});
    }
    note_worst(record, {"step held down", "-", held_down, 20, t, nowhere});
    if (const Level* air = simulation.gas())
        note_worst(record,
                   {"Mach number of the air", "-", air->system().extremes.speed / air->system().setup.state_equation.c0,
                    trusted_air_mach, t, air->system().extremes.fastest_place});
    note_worst(record, {"particles lost", "-", lost, 0, t, nowhere});
    watch_edges(t, sizes, record);
    for (const auto& body : simulation.bodies())
        if (const std::optional<double> made = body->energy_made_lately())
            note_worst(record, {interface_line, "%", 100 * *made, 100 * trusted_interface_energy, t, nowhere});
}

}  // namespace tw
