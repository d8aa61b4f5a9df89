#pragma once
#include <filesystem>

#include "sph_solver/solver.h"

namespace tw {

/// Everything a run needs to go on bitwise the same, in one HDF5 file, written atomically (raw, no compression).
/// The caller marks the restart point in the running solver too, so that both build their lists anew at this step.
void write_checkpoint(const std::filesystem::path& file, const std::string& run_hash, const Solver& solver,
                      double mass_at_start);

struct Checkpoint {
    Solver::Restart state;
    Particles particles;
    double mass_at_start = 0;
    Solver::Restart air_state;
    Particles air;  ///< empty without the effect
};
/// Throws InputError naming the file: not there, cut off, of another scene, resolution or other numerics.
Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& run_hash);

}  // namespace tw
