#pragma once
#include <filesystem>
#include <string>

#include "app/commands.h"
#include "app/facts_json.h"
#include "record/run_record.h"

namespace tw::app {

/// How one method of a scene is to be run.
struct MethodRun {
    std::filesystem::path folder;  ///< of this method's run
    bool resume = false, overwrite = false;
    int threads = 0;  ///< 0: the scene's
};
/// Runs it with a progress bar; stops at the user's wish after saving state.
RunRecord run_method(const std::string& method, const Scene& scene, const MethodRun& run, const Common& common);

RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder);
/// "sph: finished, 4.56e+04 particles, ..." with a line end.
std::string closing_line(const RunFacts& facts);

}  // namespace tw::app
