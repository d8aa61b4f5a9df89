#include "sph_solver/measure/level_ledger.h"

namespace tw {

std::vector<LevelLedger> level_ledgers(const Simulation& simulation) {
    std::vector<LevelLedger> ledgers;
    KindCounts coarser;
    for (std::size_t k = 0; k < simulation.water().size(); ++k) {
        const Level& level = simulation.level(k);
        LevelLedger& l = ledgers.emplace_back();
        l.spacing = level.system().setup.dp, l.dt = level.system().dt;
        const KindCounts kinds = level.fields().kinds();
        l.buffers = kinds.buffers, l.overlap = kinds.overlap, l.slaves = kinds.slaves;
        l.active = level.fields().count() - kinds.buffers - kinds.under();
        l.seconds = level.timers().sum();
        if (k > 0) {
            const Refinement& edge = simulation.refinements()[k - 1];
            l.edge = edge.ledger();
            l.mass_drift = edge.mass_drift(coarser, kinds);
        }
        coarser = kinds;
    }
    return ledgers;
}

std::vector<ResolvedBox> resolution_of(const Simulation& simulation) {
    std::vector<ResolvedBox> finer;
    for (const Refinement& edge : simulation.refinements())
        for (const Box& box : edge.zone().sliced()) finer.push_back({edge.fine().system().setup.dp, box});
    return resolution_within({simulation.level(0).system().setup.dp, simulation.setup().domain}, finer);
}

}  // namespace tw
