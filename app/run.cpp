#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/output.h"
#include "app/run_method.h"
#include "app/stop_signal.h"
#include "base/errors.h"
#include "compare/compare.h"
#include "foam_cases/doctor.h"
#include "scene/hash.h"

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

}  // namespace

int run_run(const RunCommand& command, const Common& common) {
    const PlannedRun plan = plan_run(command.scene.file, command.scene.overrides(), command.method, command.threads);
    const auto& [scene, prediction] = plan;

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
    bool failed = false;
    for (const std::string method : {"sph", "fvm"}) {  // in this order, whatever the scene's
        if (std::find(scene.run.methods.begin(), scene.run.methods.end(), method) == scene.run.methods.end()) continue;
        const bool resume = command.resume && fs::exists(out / method);
        RunRecord record;
        try {
            record = run_method(method, plan, {out / method, resume, command.overwrite}, common);
        } catch (const RunError& e) {  // the other method goes on, and what there is is reported
            std::fputs(fmt::format("{}: {}\n", method, e.what()).c_str(), stderr);
            failed = true;
            continue;
        }
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
        if (fs::exists(out / method / "record.h5")) {
            RunRecord record = read_record(out / method / "record.h5");
            // beside a failed run only what is of this scene: a report of another one's would mislead
            if (!failed || record.attributes["run_hash"] == run_hash(scene, method))
                records.push_back(std::move(record));
        }
    if (records.empty() || (records.size() < 2 && !failed)) {
        write_json(common, runs_json(runs));
        return failed ? run_failed : done;
    }
    const bool both_now = scene.run.methods.size() == 2;
    try {
        const Comparison comparison = compare_records(std::move(records));
        const ReportFiles files = write_report(comparison, out);
        say(common, summary_text(comparison) + "\nreport: " + files.html.string() + "\n");
        write_json(common, comparison_json(comparison));
    } catch (const InputError& e) {
        if (both_now && !failed) throw;
        // The other method's record is from an earlier scene: that takes nothing from this run.
        say(common, std::string("not compared: ") + e.what() + "\n");
        write_json(common, runs_json(runs));
    }
    return failed ? run_failed : done;
}

}  // namespace tw::app
