#include "sph_solver/measure/certificate.h"

#include <algorithm>

#include "record/certificate.h"

namespace tw {

void watch_stability(const Solver& solver, RunRecord& record) {
    const SolverSetup& s = solver.setup();
    const Extremes& e = solver.extremes();
    const double t = solver.time(), c0 = s.state_equation.c0, percent = 100 / s.rho0;
    const Vec3 nowhere = CertificateLine{}.place;
    const auto acoustic_step = [&](const Solver& phase) {
        return s.cfl * phase.h() / (phase.setup().state_equation.c0 + phase.extremes().speed);
    };
    const double acoustic =
        solver.air() ? std::min(acoustic_step(solver), acoustic_step(*solver.air())) : acoustic_step(solver);
    const double deviation = 100 * largest_density_deviation;
    note_worst(record, {"Mach number", "-", e.speed / c0, trusted_mach, t, e.fastest_place});
    note_worst(record,
               {"compression", "%", percent * e.density_deviation_high, 100 * trusted_compression, t, e.densest_place});
    note_worst(record, {"rarefaction", "%", -percent * e.density_deviation_low, deviation, t, e.thinnest_place});
    note_worst(record, {"step held down", "-", solver.dt() > 0 ? acoustic / solver.dt() : 0, 20, t, nowhere});
    if (const Solver* air = solver.air())
        note_worst(record, {"Mach number of the air", "-", air->extremes().speed / air->setup().state_equation.c0,
                            trusted_air_mach, t, air->extremes().fastest_place});
    note_worst(record, {"particles lost", "-",
                        static_cast<double>(solver.ledger().lost + (solver.air() ? solver.air()->ledger().lost : 0)), 0,
                        t, nowhere});
}

}  // namespace tw
