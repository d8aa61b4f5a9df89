#include "app/run_method.h"

#include <fmt/format.h>

#include "app/machine_pace.h"
#include "app/progress_bar.h"
#include "app/stop_signal.h"
#include "foam_cases/run_fvm.h"
#include "sph_solver/run_sph.h"

namespace tw::app {

PlannedRun plan_run(const std::filesystem::path& file, const SceneOverrides& overrides, const std::string& method,
                    int threads) {
    Scene scene = read_scene(file, overrides);
    if (method == "both")
        scene.run.methods = {"sph", "fvm"};
    else if (!method.empty())
        scene.run.methods = {method};
    if (threads > 0) scene.run.threads = threads;
    for (const std::string& m : scene.run.methods) refuse_unsolved(scene, m);
    const Prediction prediction = predict(scene, machine_pace());
    refuse_oversize(scene, prediction);
    return {std::move(scene), prediction};
}

RunRecord run_method(const std::string& method, const PlannedRun& plan, const MethodRun& run, const Common& common) {
    const Scene& scene = plan.scene;
    RunOptions options;
    options.folder = run.folder;
    options.resume = run.resume;
    options.overwrite = run.overwrite;
    options.threads = scene.run.threads;
    options.predicted_seconds = plan.seconds(method);
    options.predicted_elements =
        method == "sph" ? plan.prediction.particles + plan.prediction.wall_particles + plan.prediction.air_particles
                        : plan.prediction.cells;
    options.predicted_bytes = method == "sph" ? plan.prediction.sph_bytes : plan.prediction.fvm_bytes;
    options.command = common.command;
    ProgressBar bar(method, common.quiet);
    options.progress = [&bar](const Progress& p) { bar.show(p); };
    options.stop_asked = stop_asked;
    RunRecord record = method == "sph" ? run_sph(scene, options) : run_fvm(scene, options);
    // what an effect costs is an estimate of its own, and air's is the roughest
    if (record.state == "finished" && !run.resume && !scene.effect_on("air")) {
        const Prediction by_table = predict(scene);
        double taken = 0;
        for (const Phase& phase : record.phases) taken += phase.wall;
        learn_pace(method, method == "sph" ? by_table.sph_seconds : by_table.fvm_seconds, taken);
    }
    return record;
}

RunFacts facts_of(const std::string& method, const RunRecord& record, const std::filesystem::path& folder) {
    RunFacts f{method, record.state, record.reason, (folder / "record.h5").string(), record.elements, record.steps, 0};
    for (const Phase& phase : record.phases) f.wall += phase.wall;
    return f;
}

std::string closing_line(const RunFacts& f) {
    return fmt::format("{}{}, {:.3g} {}, {:.3g} steps, {:.3g} s, {}\n", f.state,
                       f.reason.empty() ? "" : ": " + f.reason, f.elements, f.method == "sph" ? "particles" : "cells",
                       f.steps, f.wall, f.record);
}

}  // namespace tw::app
