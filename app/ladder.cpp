#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/campaign.h"
#include "app/output.h"
#include "app/stop_signal.h"
#include "app/write_ladder.h"
#include "base/errors.h"
#include "compare/report/report_table.h"
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
    CampaignRun run;
    const Choice* choice = nullptr;  ///< none: a level
};

Job job_of(PlannedRun plan, const std::string& method, const fs::path& folder, const Choice* choice = nullptr) {
    const std::string name = fmt::format("{} at {:g} m{}", method, plan.scene.resolution.near_hull,
                                         choice ? fmt::format(", {}", choice->name) : "");
    return {{name, method, std::move(plan), folder}, choice};
}

/// The scene's own size and coarser ones in every method, and each choice at the second coarsest; cheapest first.
std::vector<Job> jobs_of(const LadderCommand& command, const fs::path& out) {
    std::vector<Job> jobs;
    for (int k = command.levels - 1; k >= 0; --k) {
        SceneOverrides overrides = command.scene.overrides();
        overrides.scale_resolution = overrides.scale_resolution.value_or(1) * std::pow(command.ratio, k);
        const PlannedRun plan = plan_run(command.scene.file, overrides, command.method, command.threads);
        const fs::path folder = out / fmt::format("near_hull_{:.6g}mm", 1000 * plan.scene.resolution.near_hull);
        for (const std::string& method : plan.scene.run.methods) {
            jobs.push_back(job_of(plan, method, folder / method));
            if (!command.variations || k != std::max(0, command.levels - 2)) continue;
            for (const Choice& choice : choices) {
                if (choice.method != method) continue;
                SceneOverrides varied = overrides;
                varied.*choice.factor = choice.value;
                jobs.push_back(job_of(plan_run(command.scene.file, varied, command.method, command.threads), method,
                                      folder / choice.folder / method, &choice));
            }
        }
    }
    std::ranges::stable_sort(jobs, {}, [](const Job& j) { return j.run.plan.seconds(j.run.method); });
    return jobs;
}

/// What will be run, in this order, and what it is expected to take.
std::string plan_text(const std::vector<Job>& jobs, double budget) {
    ReportTable table{
        "",
        {words("run"), numbers("elements"), numbers("predicted time", "s"), numbers("together", "s"), words("state")}};
    double together = 0;
    for (const auto& [run, choice] : jobs) {
        const double cost = run.plan.seconds(run.method);
        const Prediction& p = run.plan.prediction;
        const double elements = run.method == "sph" ? p.particles + p.air_particles : p.cells;
        const bool finished = is_finished(run), fits = finished || together + cost <= budget;
        if (fits && !finished) together += cost;
        table.rows.push_back({{run.name, elements, cost, finished || !fits ? ReportCell("") : ReportCell(together),
                               finished ? "finished before"
                               : fits   ? ""
                                        : "beyond the budget"}});
    }
    return text_of(table);
}

/// Takes one run into the ladder. False: stopped on request. One that fails, or does not fit, is left out and
/// named in the report; the others are run all the same.
bool take(LadderHarvest& harvest, const Job& job, CampaignResult result) {
    using State = CampaignResult::State;
    if (result.state == State::stopped) return false;
    if (!result.there()) {
        const bool failed = result.state == State::failed;
        harvest.left_out.push_back(job.run.name + ": " + (failed ? "failed: " : "") + result.why_not);
        harvest.any_failed |= failed;
    } else if (job.choice) {
        harvest.variations.push_back({job.choice->name, job.choice->share, ladder_run(std::move(*result.record))});
    } else {
        harvest.take(std::move(*result.record), job.run.folder / "record.h5");
    }
    return true;
}

}  // namespace

int run_ladder(const LadderCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_ladder") : command.out;
    const std::vector<Job> jobs = jobs_of(command, out);
    say(common, plan_text(jobs, command.budget_seconds()));
    if (command.plan) return done;
    const std::vector<RunRecord> measured = measured_records(command.measured);  // before hours are spent
    if (std::ranges::any_of(jobs, [](const Job& j) { return j.run.method == "fvm"; }))
        say(common, "OpenFOAM: " + sound_openfoam(jobs.front().run.plan.scene.fvm.openfoam).verdict + "\n");

    catch_stop_signals();
    LadderHarvest harvest;
    Campaign campaign(common, {.overwrite = command.overwrite, .budget = command.budget_seconds()});
    for (const Job& job : jobs)
        if (!take(harvest, job, campaign.run_or_take(job.run))) {
            complain("ladder: stopped on request; the same command continues from here");
            return run_failed;
        }
    harvest.drop_lone_variations();
    if (harvest.runs.empty() && harvest.any_failed)
        throw RunError("no run of the ladder is left: " + harvest.left_out.front());
    if (harvest.runs.empty())
        throw InputError(fmt::format("--budget {}: no run fits; the cheapest needs about {:.3g} s", command.budget,
                                     jobs.front().run.plan.seconds(jobs.front().run.method)));
    write_ladder(harvest, measured, out, common);
    return harvest.any_failed ? run_failed : done;
}

}  // namespace tw::app
