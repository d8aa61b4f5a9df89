#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/facts_json.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "app/stop_signal.h"
#include "base/errors.h"
#include "compare/compare.h"
#include "foam_cases/doctor.h"
#include "foam_cases/run_fvm.h"
#include "sph_solver/run_sph.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// A folder that holds a run is refused before the other method spends an hour.
void refuse_taken(const fs::path& folder, const RunCommand& command) {
    const bool taken = fs::exists(folder / "record.h5") || fs::exists(folder / "checkpoint.h5");
    if (taken && !command.resume && !command.overwrite)
        throw InputError(
            fmt::format("{}: holds a run already; go on with it by --resume, begin anew by --overwrite, or choose "
                        "another folder by --out",
                        folder.string()));
}

RunRecord run_method(const std::string& method, const Scene& scene, const fs::path& out, const RunCommand& command,
                     const Common& common) {
    RunOptions options;
    options.folder = out / method;
    options.resume = command.resume && fs::exists(options.folder);
    options.overwrite = command.overwrite;
    options.threads = command.threads > 0 ? command.threads : scene.run.threads;
    ProgressBar bar(method, common.quiet);
    options.progress = [&bar](const Progress& p) { bar.show(p); };
    options.stop_asked = stop_asked;
    return method == "sph" ? run_sph(scene, options) : run_fvm(scene, options);
}

RunFacts facts_of(const std::string& method, const RunRecord& record, const fs::path& folder) {
    RunFacts f{method, record.state, record.reason, (folder / "record.h5").string(), record.elements, record.steps, 0};
    for (const Phase& phase : record.phases) f.wall += phase.wall;
    return f;
}

std::string closing_line(const RunFacts& f) {
    return fmt::format("{}: {}{}, {:.3g} {}, {:.3g} steps, {:.3g} s, {}\n", f.method, f.state,
                       f.reason.empty() ? "" : ": " + f.reason, f.elements, f.method == "sph" ? "particles" : "cells",
                       f.steps, f.wall, f.record);
}

}  // namespace

int run_run(const RunCommand& command, const Common& common) {
    Scene scene = read_scene(command.scene.file, command.scene.overrides());
    if (command.method == "both")
        scene.run.methods = {"sph", "fvm"};
    else if (!command.method.empty())
        scene.run.methods = {command.method};
    if (command.threads > 0) scene.run.threads = command.threads;
    const Prediction prediction = predict(scene);
    refuse_oversize(scene, prediction);

    const fs::path out = command.out.empty() ? fs::path("runs") / command.scene.file.stem() : command.out;
    bool with_fvm = false;
    for (const std::string& method : scene.run.methods) {
        refuse_taken(out / method, command);
        with_fvm |= method == "fvm";
    }
    if (with_fvm) say(common, "OpenFOAM: " + sound_openfoam(scene.fvm.openfoam).verdict + "\n");
    say(common, fmt::format("{}\n{:.3g} particles about {:.3g} s, {:.3g} cells about {:.3g} s; results in {}\n",
                            scene.title, prediction.particles, prediction.sph_seconds, prediction.cells,
                            prediction.fvm_seconds, out.string()));

    catch_stop_signals();
    std::vector<RunFacts> runs;
    for (const std::string method : {"sph", "fvm"}) {  // in this order, whatever the scene's
        if (std::find(scene.run.methods.begin(), scene.run.methods.end(), method) == scene.run.methods.end()) continue;
        const RunRecord record = run_method(method, scene, out, command, common);
        runs.push_back(facts_of(method, record, out / method));
        say(common, closing_line(runs.back()));
        if (record.state != "finished" || stop_asked()) {
            std::fputs(
                fmt::format("{}: stopped at the user's wish; state saved, go on with --resume\n", method).c_str(),
                stderr);
            write_json(common, runs_json(runs));
            return run_failed;
        }
    }

    std::vector<RunRecord> records;
    for (const char* method : {"sph", "fvm"})
        if (fs::exists(out / method / "record.h5")) records.push_back(read_record(out / method / "record.h5"));
    if (records.size() < 2) {
        write_json(common, runs_json(runs));
        return done;
    }
    const bool both_now = scene.run.methods.size() == 2;
    try {
        const Comparison comparison = compare_records(std::move(records));
        const ReportFiles files = write_report(comparison, out);
        say(common, summary_text(comparison) + "\nreport: " + files.html.string() + "\n");
        write_json(common, comparison_json(comparison));
    } catch (const InputError& e) {
        if (both_now) throw;
        // The other method's record is from an earlier scene: that takes nothing from this run.
        say(common, std::string("not compared: ") + e.what() + "\n");
        write_json(common, runs_json(runs));
    }
    return done;
}

}  // namespace tw::app
