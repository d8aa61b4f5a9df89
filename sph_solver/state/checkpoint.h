#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sph_solver/simulation.h"

namespace tw {

/// Everything a run needs to continue bitwise the same, as one HDF5 file with a group for each owner:
///
///   /simulation        run hash, instruction set, mass at the start
///   /levels/0, 1, ...  time, step, ledger, extremes and the particles of each level; splits and merges at their edges
///   /control_volume    its running sums, where there is one
///   /bodies/0, 1, ...  how the bodies that move stand and move, in their order, see Body::state
struct Checkpoint {
    std::string isa;           ///< of the pair loops: another one may give other last digits
    double mass_at_start = 0;  ///< of the water [kg]
    struct OfLevel {
        std::string material;
        Level::State state;
        Particles particles;
    };
    std::vector<OfLevel> levels;
    struct Edge {
        std::int64_t splits = 0, merges = 0;
    };
    std::vector<Edge> edges;  ///< between levels of particle size, coarsest first
    std::optional<ControlVolume::State> control;
    std::vector<std::vector<double>> bodies;  ///< Body::state of those that move
};

/// Of the run as it is now, with all that is saved of the particles and nothing else. All of several ranks call it, and
/// the first one has what one process has. The caller marks the restart point in the running simulation too, so that
/// both build their lists anew at this step.
Checkpoint checkpoint_of(const Simulation& simulation, double mass_at_start);
/// Written atomically (raw, no compression). Throws RunError.
void write_checkpoint(const std::filesystem::path& file, const std::string& run_hash, Checkpoint checkpoint);

/// `with_particles`: of several ranks the first one reads them, and whether the file is as it was written; the others
/// read all else. Throws InputError naming the file: not there, cut off, damaged, of another scene, resolution or other
/// numerics.
Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& run_hash, bool with_particles = true);

/// Gives the simulation the checkpoint's state. All of several ranks call it. Throws InputError when its levels are not
/// the checkpoint's.
void restore(Simulation& simulation, Checkpoint checkpoint);

}  // namespace tw
