#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/output.h"
#include "app/run_method.h"
#include "app/stop_signal.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/doctor.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// One size of the scene.
struct Rung : PlannedRun {
    fs::path folder;
};

double predicted(const Rung& rung, const std::string& method) {
    return method == "sph" ? rung.prediction.sph_seconds : rung.prediction.fvm_seconds;
}

/// The scene's own size and coarser ones, cheapest first.
std::vector<Rung> rungs_of(const LadderCommand& command, const fs::path& out) {
    std::vector<Rung> rungs;
    for (int k = command.levels - 1; k >= 0; --k) {
        const double scale = std::pow(command.ratio, k);
        SceneOverrides overrides = command.scene.overrides();
        overrides.scale_resolution = overrides.scale_resolution.value_or(1) * scale;
        PlannedRun plan = plan_run(command.scene.file, overrides, command.method, command.threads);
        const fs::path folder = out / fmt::format("near_hull_{:.6g}mm", 1000 * plan.scene.resolution.near_hull);
        rungs.push_back({std::move(plan), folder});
    }
    return rungs;
}

/// The record of an earlier run of the very same scene in this folder, if it is finished.
std::optional<RunRecord> finished(const fs::path& folder, const Scene& scene) {
    const fs::path file = folder / "record.h5";
    if (!fs::exists(file)) return {};
    RunRecord record = read_record(file);
    const auto hash = record.attributes.find("scene_hash");
    const auto duration = record.numbers.find("duration");  // not in the hash: a run may be made longer
    const bool same = record.state == "finished" && hash != record.attributes.end() && hash->second == scene.hash &&
                      duration != record.numbers.end() && duration->second >= scene.run.duration;
    return same ? std::optional(std::move(record)) : std::nullopt;
}

}  // namespace

int run_ladder(const LadderCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_ladder") : command.out;
    const double budget = command.budget_seconds();
    const std::vector<Rung> rungs = rungs_of(command, out);
    const std::vector<std::string>& methods = rungs.front().scene.run.methods;
    if (std::find(methods.begin(), methods.end(), "fvm") != methods.end())
        say(common, "OpenFOAM: " + sound_openfoam(rungs.front().scene.fvm.openfoam).verdict + "\n");

    catch_stop_signals();
    std::vector<RunRecord> records;
    double spent = 0;  // predicted seconds of what is run now: what is there already costs nothing
    for (const Rung& rung : rungs)
        for (const std::string& method : methods) {
            const fs::path folder = rung.folder / method;
            const double size = rung.scene.resolution.near_hull, cost = predicted(rung, method);
            if (auto earlier = finished(folder, rung.scene)) {
                records.push_back(std::move(*earlier));
                say(common,
                    fmt::format("{} at {:g} m: finished before, taken from {}\n", method, size, folder.string()));
            } else if (spent + cost > budget) {
                say(common,
                    fmt::format("{} at {:g} m: left out, about {:.3g} s more; the budget is {:.3g} s and {:.3g} s "
                                "of it are taken\n",
                                method, size, cost, budget, spent));
            } else {
                spent += cost;
                say(common, fmt::format("{} at {:g} m: about {:.3g} s\n", method, size, cost));
                const bool resume = fs::exists(folder) && !command.overwrite;
                const RunRecord record = run_method(method, rung.scene, {folder, resume, command.overwrite}, common);
                say(common, closing_line(facts_of(method, record, folder)));
                if (record.state != "finished" || stop_asked()) {
                    std::fputs("ladder: stopped at the user's wish; the same command goes on from here\n", stderr);
                    return run_failed;
                }
                records.push_back(read_record(folder / "record.h5"));
            }
        }
    if (records.empty())
        throw InputError(fmt::format("--budget {}: no run fits; the cheapest needs about {:.3g} s", command.budget,
                                     predicted(rungs.front(), methods.front())));
    const Ladder ladder = build_ladder(std::move(records));
    const std::string text = ladder_text(ladder), json = ladder_json(ladder);
    write_text_atomically(out / "ladder.md", text);
    write_text_atomically(out / "ladder.json", json);
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        write_text_atomically(out / ("ladder_" + ladder.sides[k].method + ".csv"), ladder_csv(ladder, k));
    say(common, "\n" + text + "\nwritten: " + (out / "ladder.md").string() + "\n");
    write_json(common, json);
    return done;
}

}  // namespace tw::app
