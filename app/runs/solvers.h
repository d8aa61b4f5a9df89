#pragma once
#include <string>
#include <vector>

#include "record/run_record.h"
#include "scene/run/run_options.h"
#include "scene/scene.h"

namespace tw::app {

/// What runs one method of methods/methods.h. A further solver is its folder, a row there and a row here.
struct Solver {
    std::string method;
    MethodCost (*predict)(const Scene& scene, const Prediction& size, double pace) = nullptr;
    RunRecord (*run)(const Scene& scene, const RunOptions& options) = nullptr;
    /// Elements that are worth a rank of MPI; 0: it runs as threads, whose number does not change a bit of the results.
    double elements_per_rank = 0;
    std::string state = {};  ///< file or folder of a run, beside record.h5, from which it is resumed
    /// Throws InputError where the method cannot solve what the scene asks for. Null: it solves every scene.
    void (*refuse)(const Scene& scene) = nullptr;
    /// Makes sure of what the method needs on this machine and says so in a line. Throws InputError: it is not there.
    /// Null: it needs nothing. `sizes`: of the scene, where they have been predicted.
    std::string (*ready)(const Scene& scene, const Prediction* sizes) = nullptr;
};
/// In the order of methods().
const std::vector<Solver>& solvers();
/// Throws InputError with the names that are known.
const Solver& solver_of(const std::string& method);

/// What stands for all of them on the command line.
inline constexpr const char* every_method = "both";
/// The names, and that.
std::vector<std::string> method_choices();

/// Under which name runs of a method teach the machine's speed.
struct PaceName {
    std::string name;  ///< of the method, and of the GPU where that makes the steps
    bool of_gpu = false;
    double cores =
        1;  ///< that the table reckons with, where the pace is that of all of them: a GPU's, whose speed does
            ///< not depend on the threads beside it
};
PaceName pace_of(const Scene& scene, const std::string& method, const Prediction* sizes = nullptr);
/// The name where the GPU here makes the steps.
std::string pace_on_gpu(const std::string& method);
/// Of every method, by what runs have taught of this machine's speed (machine_pace.h).
Prediction predict_here(const Scene& scene);
/// Of every method, as on the machine that the throughput table was made on.
Prediction predict_by_table(const Scene& scene);
/// A line of each of these methods that says one.
std::string ready_text(const std::vector<std::string>& methods, const Scene& scene, const Prediction* sizes = nullptr);

}  // namespace tw::app
