#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace tw {

struct Prediction;
struct RunRecord;

struct Progress {
    double time = 0, duration = 0;  ///< simulated [s]
    double wall = 0, eta = 0;       ///< [s]
    long steps = 0;
    std::string note;  ///< phase or state, e.g. "meshing", "dt 1.2e-4 s"
    /// What is known of the run so far: its tables and certificate grow while it runs. Null where nothing is; valid in the
    /// call alone.
    const RunRecord* so_far = nullptr;
};

/// How one method is run. Both solvers take this and leave `folder/record.h5`.
struct RunOptions {
    std::filesystem::path folder;  ///< of this method's run, e.g. runs/my_scene/sph
    bool resume = false;           ///< go on from the last checkpoint; without it a folder that holds a run is refused
    bool overwrite = false;        ///< begin anew in a folder that holds a run
    int threads = 0;               ///< 0: all cores (OpenMP threads; MPI ranks for the FVM side)
    /// As said before the run, see MethodCost; go into its record; 0: not said. [s], [s], [-], [bytes], [-]
    double predicted_seconds = 0, predicted_core_seconds = 0, predicted_elements = 0, predicted_bytes = 0,
           predicted_steps = 0;
    const Prediction* prediction = nullptr;  ///< of the scene, where it has been made; it has to outlive the run
    std::string command;  ///< that makes the run again, a word a line; goes into its record; empty: not said
    std::function<void(const Progress&)> progress = {};
    std::function<bool()> stop_asked = {};  ///< polled: true ends the run after saving state
};

}  // namespace tw
