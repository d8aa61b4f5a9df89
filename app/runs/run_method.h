#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "app/arguments/commands.h"
#include "record/run_record.h"
#include "scene/run/run_options.h"
#include "scene/uncertain.h"

namespace tw::app {

/// What is asked of a scene: all that it takes to plan the very same run in another process.
struct RunRequest {
    std::filesystem::path file;
    SceneOverrides overrides = {};
    std::string method = {};      ///< a name, or every_method; empty: the scene's
    int threads = 0;              ///< 0: the scene's
    bool snapshots = true;        ///< false: not even of the last moment
    int ranks = 1;                ///< 0: the scene's
    bool elsewhere = false;       ///< made on other machines, of whose memory nothing is known here
    ChangedNumbers numbers = {};  ///< of the scene file that are others than it says
};
/// A scene as it will be run, and what that is expected to cost on this machine.
struct PlannedRun {
    RunRequest request;
    Scene scene;
    Prediction prediction;
    double seconds(const std::string& method) const { return prediction.of(method).seconds; }
};
/// Throws InputError: the scene is wrong, or too large for this machine, or for one of those that share it. All ranks
/// call it.
PlannedRun plan_run(const RunRequest& request);

/// How one method of a scene is to be run.
struct MethodRun {
    std::filesystem::path folder;  ///< of this method's run
    bool resume = false, overwrite = false;
    std::function<void(const Progress&)> progress = {};  ///< called as well
};
/// Runs it with a progress bar; stops on request after saving state. What it took is remembered for the next
/// prediction (machine_pace.h).
RunRecord run_method(const std::string& method, const PlannedRun& plan, const MethodRun& run, const Common& common);

/// What a run left.
struct RunFacts {
    std::string method, state, reason, record;
    double elements = 0, steps = 0, wall = 0;  ///< wall: time [s]
};
RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder);
/// "finished, 4.56e+04 particles, ..." with a line end.
std::string closing_line(const RunFacts& facts);

}  // namespace tw::app
