#include <fmt/format.h>

#include <algorithm>

#include "app/campaign.h"
#include "app/output.h"
#include "app/stop_signal.h"
#include "base/errors.h"
#include "compare/compare.h"
#include "foam_cases/doctor.h"
#include "scene/hash.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// In this order, whatever the scene's.
std::vector<std::string> methods_of(const Scene& scene) {
    std::vector<std::string> methods;
    for (const char* method : {"sph", "fvm"})
        if (std::ranges::find(scene.run.methods, method) != scene.run.methods.end()) methods.emplace_back(method);
    return methods;
}

/// A folder that holds a run is refused before the other method spends an hour.
void refuse_taken(const fs::path& folder, const RunCommand& command) {
    const bool taken = std::ranges::any_of(std::initializer_list<const char*>{"record.h5", "checkpoint.h5", "case"},
                                           [&](const char* name) { return fs::exists(folder / name); });
    if (taken && !command.resume && !command.overwrite)
        throw InputError(
            fmt::format("{}: there is a run already; continue it with --resume, run anew with --overwrite, or choose "
                        "another folder with --out",
                        folder.string()));
}

/// "sph: 4.56e+04 particles, about 120 s": of the methods that will run.
std::string prediction_text(const PlannedRun& plan) {
    std::string text;
    for (const std::string& method : methods_of(plan.scene)) {
        const Prediction& p = plan.prediction;
        text += method == "sph" ? fmt::format("sph: {:.3g} particles", p.particles + p.air_particles)
                                : fmt::format("fvm: {:.3g} cells", p.cells);
        text += fmt::format(", about {:.3g} s\n", plan.seconds(method));
    }
    return text;
}

/// What lies in the run's folder of this very scene: another scene's record beside it would mislead.
std::vector<RunRecord> records_of(const Scene& scene, const fs::path& out, const Common& common) {
    std::vector<RunRecord> records;
    const std::vector<std::string> now = methods_of(scene);
    for (const std::string method : {"sph", "fvm"}) {
        const fs::path file = out / method / "record.h5";
        if (!fs::exists(file)) continue;
        RunRecord record = read_record(file);
        const bool run_now = std::ranges::find(now, method) != now.end();
        if (run_now ? record.attributes["run_hash"] == run_hash(scene, method)
                    : record.attributes["scene_hash"] == scene.hash)
            records.push_back(std::move(record));
        else
            say(common, fmt::format("{}: of another scene than this run, left out of the report\n", file.string()));
    }
    return records;
}

}  // namespace

int run_run(const RunCommand& command, const Common& common) {
    const PlannedRun plan = plan_run(command.scene.file, command.scene.overrides(), command.method, command.threads);
    const Scene& scene = plan.scene;
    const std::vector<std::string> methods = methods_of(scene);

    const fs::path out = command.out.empty() ? fs::path("runs") / command.scene.file.stem() : command.out;
    for (const std::string& method : methods) refuse_taken(out / method, command);
    if (std::ranges::find(methods, "fvm") != methods.end())
        say(common, "OpenFOAM: " + sound_openfoam(scene.fvm.openfoam).verdict + "\n");
    say(common, fmt::format("{}\n{}results in {}\n", scene.title, prediction_text(plan), out.string()));

    catch_stop_signals();
    Campaign campaign(common, {.overwrite = command.overwrite, .take_finished = command.resume});
    std::vector<RunFacts> runs;
    bool failed = false;
    for (const std::string& method : methods) {
        const CampaignResult result = campaign.run_or_take({method, method, plan, out / method});
        failed |= result.state == CampaignResult::State::failed;  // the other method runs all the same
        if (result.record) runs.push_back(facts_of(method, *result.record, out / method));
        if (result.state != CampaignResult::State::stopped) continue;
        complain(method + ": stopped on request, its state is saved; continue it with --resume");
        write_json(common, runs_json(runs));
        return run_failed;
    }

    std::vector<RunRecord> records = records_of(scene, out, common);
    if (records.empty()) {
        write_json(common, runs_json(runs));
        return failed ? run_failed : done;
    }
    const Comparison comparison = compare_records(std::move(records));
    const ReportFiles files = leaving_files([&] { return write_report(comparison, out); });
    say(common, "\n" + summary_text(comparison) + "\nreport: " + files.html.string() + "\n");
    write_json(common, run_json(comparison, runs));
    return failed ? run_failed : done;
}

}  // namespace tw::app
