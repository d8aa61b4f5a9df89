#pragma once
#include <cstdint>
#include <vector>

#include "record/resolution.h"
#include "sph_solver/simulation.h"

namespace tw {

/// Who is in one size of particles at a moment, and what has passed the edge of its zone. The coarsest has no edge, no
/// buffer particles; the finest stands for no other.
struct LevelLedger {
    double spacing = 0, dt = 0;                                     ///< [m], [s]
    std::int64_t active = 0, buffers = 0, overlap = 0, slaves = 0;  ///< see Kind
    Refinement::Ledger edge = {};
    double mass_drift = 0;  ///< of its zone, as a share of the zone's mass [-]
    double seconds = 0;     ///< wall time that its pair loops and lists have taken, without interpolation at edges [s]
};
/// Of the water of each size, coarsest first.
std::vector<LevelLedger> level_ledgers(const Simulation& simulation);

/// Where the zones are now.
std::vector<ResolvedBox> resolution_of(const Simulation& simulation);

}  // namespace tw
