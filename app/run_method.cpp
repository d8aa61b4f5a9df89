#include "app/run_method.h"

#include <fmt/format.h>

#include "app/progress_bar.h"
#include "app/stop_signal.h"
#include "foam_cases/run_fvm.h"
#include "sph_solver/run_sph.h"

namespace tw::app {

RunRecord run_method(const std::string& method, const Scene& scene, const MethodRun& run, const Common& common) {
    RunOptions options;
    options.folder = run.folder;
    options.resume = run.resume;
    options.overwrite = run.overwrite;
    options.threads = run.threads > 0 ? run.threads : scene.run.threads;
    ProgressBar bar(method, common.quiet);
    options.progress = [&bar](const Progress& p) { bar.show(p); };
    options.stop_asked = stop_asked;
    return method == "sph" ? run_sph(scene, options) : run_fvm(scene, options);
}

RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder) {
    RunFacts f{method, record.state, record.reason, (folder / "record.h5").string(), record.elements, record.steps, 0};
    for (const Phase& phase : record.phases) f.wall += phase.wall;
    return f;
}

std::string closing_line(const RunFacts& f) {
    return fmt::format("{}: {}{}, {:.3g} {}, {:.3g} steps, {:.3g} s, {}\n", f.method, f.state,
                       f.reason.empty() ? "" : ": " + f.reason, f.elements, f.method == "sph" ? "particles" : "cells",
                       f.steps, f.wall, f.record);
}

}  // namespace tw::app
