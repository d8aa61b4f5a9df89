#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/machine_pace.h"
#include "app/output.h"
#include "app/run_method.h"
#include "app/stop_signal.h"
#include "app/write_ladder.h"
#include "base/errors.h"
#include "foam_cases/doctor.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// A choice of a method that should not matter, made otherwise in one run.
struct Choice {
    const char *method, *name, *folder;
    double SceneOverrides::*factor;
    double value;
    double share;  ///< of the error, see LadderVariation
};
constexpr Choice choices[] = {
    // The error of weak compressibility falls with Ma^2, so with c0^-2: 1/(1 - 1/1.5^2).
    {"sph", "sound speed x 1.5", "sound_speed_1.5", &SceneOverrides::sound_speed_factor, 1.5, 1.8},
    // Errors of time stepping are taken as of first order: 1/(1 - 1/2).
    {"sph", "half the time step", "time_step_0.5", &SceneOverrides::time_step_factor, 0.5, 2},
    {"fvm", "half the Courant number", "courant_0.5", &SceneOverrides::courant_factor, 0.5, 2},
};

/// One run of the ladder.
struct Job {
    PlannedRun plan;
    std::string method;
    fs::path folder;                 ///< of this method's run
    const Choice* choice = nullptr;  ///< none: a level
    std::string what() const {
        return fmt::format("{} at {:g} m{}", method, plan.scene.resolution.near_hull,
                           choice ? fmt::format(", {}", choice->name) : "");
    }
};

/// The scene's own size and coarser ones in every method, and each choice at the second coarsest; cheapest first.
std::vector<Job> jobs_of(const LadderCommand& command, const fs::path& out) {
    std::vector<Job> jobs;
    for (int k = command.levels - 1; k >= 0; --k) {
        SceneOverrides overrides = command.scene.overrides();
        overrides.scale_resolution = overrides.scale_resolution.value_or(1) * std::pow(command.ratio, k);
        const PlannedRun plan = plan_run(command.scene.file, overrides, command.method, command.threads);
        const fs::path folder = out / fmt::format("near_hull_{:.6g}mm", 1000 * plan.scene.resolution.near_hull);
        for (const std::string& method : plan.scene.run.methods) {
            jobs.push_back({plan, method, folder / method});
            if (!command.variations || k != std::max(0, command.levels - 2)) continue;
            for (const Choice& choice : choices) {
                if (choice.method != method) continue;
                SceneOverrides varied = overrides;
                varied.*choice.factor = choice.value;
                jobs.push_back({plan_run(command.scene.file, varied, command.method, command.threads), method,
                                folder / choice.folder / method, &choice});
            }
        }
    }
    std::ranges::stable_sort(jobs, {}, [](const Job& j) { return j.plan.seconds(j.method); });
    return jobs;
}

/// What will be run, in this order, and what it is expected to take.
std::string plan_text(const std::vector<Job>& jobs, double budget) {
    std::string text = fmt::format("{:<48} {:>9} {:>10} {:>10}\n", "run", "elements", "seconds", "together");
    double together = 0;
    for (const Job& job : jobs) {
        const double cost = job.plan.seconds(job.method);
        const Prediction& p = job.plan.prediction;
        const double elements = job.method == "sph" ? p.particles + p.air_particles : p.cells;
        text += fmt::format("{:<48} {:>9.3g} {:>10.3g} ", job.what(), elements, cost);
        if (finished_run(job.folder, job.plan.scene, job.method))
            text += "  finished before\n";
        else if (together + cost > budget)
            text += "  beyond the budget\n";
        else
            text += fmt::format("{:>10.3g}\n", together += cost);
    }
    return text;
}

void take(LadderHarvest& harvest, const Job& job, RunRecord record) {
    if (job.choice)
        harvest.variations.push_back({job.choice->name, job.choice->share, ladder_run(std::move(record))});
    else
        harvest.take(std::move(record), job.folder / "record.h5");
}

/// One run, unless it is there. False: stopped at the user's wish. One that fails, or does not fit, is left out and
/// named in the report; the others go on.
bool run_one(Job& job, const LadderCommand& command, const Common& common, double& spent, LadderHarvest& harvest) {
    if (auto earlier = finished_run(job.folder, job.plan.scene, job.method)) {
        say(common, fmt::format("{}: finished before, taken from {}\n", job.what(), job.folder.string()));
        take(harvest, job, std::move(*earlier));
        return true;
    }
    const double budget = command.budget_seconds();
    job.plan.prediction = predict(job.plan.scene, machine_pace());  // the runs before have taught the pace
    const double cost = job.plan.seconds(job.method);
    if (spent + cost > budget) {
        harvest.left_out.push_back(
            fmt::format("{}: left out, about {:.3g} s more; the budget is {:.3g} s and {:.3g} s of it are taken",
                        job.what(), cost, budget, spent));
        say(common, harvest.left_out.back() + "\n");
        return true;
    }
    say(common, fmt::format("{}: about {:.3g} s\n", job.what(), cost));
    const bool anew = command.overwrite || failed_before_it_saved(job.folder, job.plan.scene, job.method);
    const bool resume = fs::exists(job.folder) && !anew;
    const auto start = std::chrono::steady_clock::now();
    const auto fail = [&](const std::string& why) {
        harvest.left_out.push_back(fmt::format("{}: failed: {}", job.what(), why));
        harvest.any_failed = true;
        std::fputs((harvest.left_out.back() + "\n").c_str(), stderr);
    };
    bool go_on = true;
    try {
        const RunRecord record = run_method(job.method, job.plan, {job.folder, resume, anew}, common);
        say(common, closing_line(facts_of(job.method, record, job.folder)));
        go_on = record.state == "finished" && !stop_asked();
        if (go_on) take(harvest, job, read_record(job.folder / "record.h5"));
    } catch (const RunError& e) { fail(e.what()); }
    spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return go_on;
}

}  // namespace

int run_ladder(const LadderCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_ladder") : command.out;
    std::vector<Job> jobs = jobs_of(command, out);
    say(common, plan_text(jobs, command.budget_seconds()));
    if (command.plan) return done;
    const std::vector<RunRecord> measured = measured_records(command.measured);  // before hours are spent
    if (std::ranges::any_of(jobs, [](const Job& j) { return j.method == "fvm"; }))
        say(common, "OpenFOAM: " + sound_openfoam(jobs.front().plan.scene.fvm.openfoam).verdict + "\n");

    catch_stop_signals();
    LadderHarvest harvest;
    double spent = 0;  // seconds of what is run now: what is there already costs nothing
    for (Job& job : jobs)
        if (!run_one(job, command, common, spent, harvest)) {
            std::fputs("ladder: stopped at the user's wish; the same command goes on from here\n", stderr);
            return run_failed;
        }
    harvest.drop_lone_variations();
    if (harvest.runs.empty() && harvest.any_failed)
        throw RunError("no run of the ladder is left: " + harvest.left_out.front());
    if (harvest.runs.empty())
        throw InputError(fmt::format("--budget {}: no run fits; the cheapest needs about {:.3g} s", command.budget,
                                     jobs.front().plan.seconds(jobs.front().method)));
    write_ladder(harvest, measured, out, common);
    return harvest.any_failed ? run_failed : done;
}

}  // namespace tw::app
