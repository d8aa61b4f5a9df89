#pragma once
#include <cstddef>
#include <vector>

#include "record/run_record.h"
#include "sph_solver/measure/level_ledger.h"

namespace tw {

/// How far the mass of each finer zone has come from that at the start. At one moment it swings by the rows of particles
/// that cross the zone's faces, coarse and fine ones not together, which is no loss: so a frame has the mean over the
/// steps since the last one, and what is checked is
///
///   |mean of the last eight frames|     0.5 % (a warning),   frames before the first counting as 0
class ZoneMass {
public:
    /// After each step of a run with several sizes of particles: of all of them, coarsest first.
    void add(const std::vector<LevelLedger>& sizes);
    /// Mean drift of the zone of size `k` > 0 since this was last asked for it, as a share of its mass [-]; 0: no step.
    double take_mean(std::size_t k);

private:
    struct Sum {
        double drift = 0;  ///< [-]
        double steps = 0;
    };
    std::vector<Sum> sums_;  ///< by size
};

/// Notes the check of a zone whose table of the record has a frame more [%], at that frame's time.
void check_zone_mass(const Table& level, RunRecord& record);

}  // namespace tw
