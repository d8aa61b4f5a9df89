#pragma once
#include <vector>

#include "record/run_record.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/simulation.h"

namespace tw {

/// The run's validity checks, kept up after each step: extreme values against the limits at which a run is stopped,
///
///   Mach number            max |u| / c0                              1
///   compression            max (rho - rho0) / rho0                   30 %
///   rarefaction            max (rho0 - rho) / rho0                   30 %
///   step held down         acoustic time step over the step taken    20 (reported, the run goes on)
///   particles lost         through walls                             0 (reported, the run goes on)
///
/// and, at frames,
///
///   crowding               |crowding| of packing.h                   1 % (a warning)
///
/// and, with several sizes of particles, the worst of all edges between them,
///
///   orphans                of the buffer particles and parents of an edge      1 % (a warning)
///
/// (the drift of a zone's mass is checked at frames, zone_mass.h)
/// and, with elastic bodies,
///
///   energy made            ElasticBody::energy_made_lately           50 % (a warning: unstable by its added mass)
/// `sizes`: level_ledgers of a simulation with several sizes of particles; of others it may be empty.
void watch_stability(const Simulation& simulation, const std::vector<LevelLedger>& sizes, RunRecord& record);
/// The same for who has not counted them.
void watch_stability(const Simulation& simulation, RunRecord& record);

}  // namespace tw
