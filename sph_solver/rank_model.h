#pragma once
#include <cstdint>
#include <vector>

#include "sph_solver/simulation.h"

namespace tw {

/// What many ranks would make of a run, found on one machine: the pencils are divided as the run divides them, and
/// counted; the time of what ranks exchange is a model of these counts and of a stated machine
/// (docs/decisions/067-ranks.md).

/// Pencils of one size of particles, and what stands in them.
struct PencilsOfSize {
    PencilGrid grid, blocks;
    std::vector<std::int64_t> work, particles;  ///< of each pencil
    WidePlace low, high;
    std::int64_t reach;
    double all_work = 0, all_particles = 0;  ///< [-]
    int steps = 1;                           ///< of this size in one of the largest
};
/// `finer`: cut into finer x finer pencils each, which share its work and its particles, finer^3 times as many. Work is
/// that of the pairs, or of the particles before the first step.
PencilsOfSize pencils_of(const Level& level, int finer, int steps);
/// Those of all sizes of water.
std::vector<PencilsOfSize> pencils_of_water(const Simulation& simulation, int finer = 1);

/// What the division of one size between ranks comes to.
struct Division {
    bool possible = false;     ///< each rank has some
    double imbalance = 0;      ///< work, largest over mean [-]
    double copies = 0;         ///< of the rank with most [-]
    double own_particles = 0;  ///< of the rank with most [-]
    double all_copies = 0;     ///< [-]
    double neighbours = 0;     ///< of the rank with most [-]
};
Division divide(const PencilsOfSize& pencils, const Mirrors& mirrors, int ranks);

/// The machine of the model: a rank is a core of a node with 64, which share a network card of 25 GB/s.
struct MachineOfRanks {
    double pace = 2.0e6;           ///< evaluations of the largest density of pairs that a core makes a second [1/s]
    double latency = 2e-6;         ///< of a message [s]
    double bandwidth = 25e9 / 64;  ///< of a rank [B/s]
};
/// What was counted (bench_ranks): for each step of one size.
struct CountedOfRanks {
    double exchanges = 6.3, collectives = 4.1, bytes_a_copy = 60;  ///< [-], [-], [bytes]
};
/// Time of the exchange between ranks that a step of one size needs [s].
double seconds_of_talk(const Division& division, int ranks, const MachineOfRanks& machine = {},
                       const CountedOfRanks& counted = {});

}  // namespace tw
