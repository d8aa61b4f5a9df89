#pragma once
#include <filesystem>
#include <string>

#include "app/commands.h"
#include "app/facts_json.h"
#include "record/run_record.h"

namespace tw::app {

/// A scene as it will be run, and what that is expected to cost on this machine.
struct PlannedRun {
    Scene scene;
    Prediction prediction;
    double seconds(const std::string& method) const { return prediction.of(method).seconds; }
};
/// `method`: a name, or every_method; empty: the scene's. `threads`: 0: the scene's. Throws InputError: the scene is
/// wrong, or too large for this machine.
PlannedRun plan_run(const std::filesystem::path& file, const SceneOverrides& overrides, const std::string& method,
                    int threads);

/// How one method of a scene is to be run.
struct MethodRun {
    std::filesystem::path folder;  ///< of this method's run
    bool resume = false, overwrite = false;
};
/// Runs it with a progress bar; stops on request after saving state. What it took is remembered for the next
/// prediction (machine_pace.h).
RunRecord run_method(const std::string& method, const PlannedRun& plan, const MethodRun& run, const Common& common);

RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder);
/// "finished, 4.56e+04 particles, ..." with a line end.
std::string closing_line(const RunFacts& facts);

}  // namespace tw::app
