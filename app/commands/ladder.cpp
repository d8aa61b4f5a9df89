#include "compare/grid_study/grid_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/arguments/output.h"
#include "app/campaign/budget.h"
#include "app/campaign/campaign.h"
#include "app/campaign/grid_study_jobs.h"
#include "app/campaign/report_every.h"
#include "app/campaign/write_grid_study.h"
#include "app/runs/ranks.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// What will be run, in this order, and what it is expected to take.
std::string plan_text(const GridStudyPlan& plan, double budget) {
    ReportTable table{
        "",
        {words("run"), numbers("elements"), numbers("predicted time", "s"), numbers("together", "s"), words("state")}};
    double together = 0;
    for (const auto& [run, choice, fills_in] : plan.jobs) {
        const double cost = run.plan.seconds(run.method);
        const double elements = run.plan.prediction.of(run.method).elements;
        const bool finished = is_finished(run), fits = finished || together + cost <= budget;
        if (fits && !finished) together += cost;
        table.rows.push_back({{run.name, elements, cost, finished || !fits ? ReportCell("") : ReportCell(together),
                               finished ? "finished before"
                               : fits   ? ""
                                        : "beyond the budget"}});
    }
    std::string text = text_of(table);
    for (const std::string& line : plan.left_out) text += "! " + line + "\n";
    return text;
}

}  // namespace

int run_grid_study(const LadderCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_ladder") : command.out;
    const GridStudyPlan plan = plan_grid_study({.request = {.file = command.scene.file,
                                                            .overrides = command.scene.overrides(),
                                                            .method = command.method,
                                                            .threads = command.threads,
                                                            .elsewhere = command.making.elsewhere()},
                                                .levels = command.levels,
                                                .ratio = command.ratio,
                                                .variations = command.variations,
                                                .surface = command.surface,
                                                .box = command.variations,
                                                .fill = command.fill},
                                               out);
    const std::vector<GridStudyJob>& jobs = plan.jobs;
    const double budget = budget_seconds(command.budget);
    say(common, plan_text(plan, budget) + unused_ranks(jobs.front().run.plan.scene));
    if (command.plan) return done;
    refuse_report_every(command.making);
    const std::vector<RunRecord> measured = measured_records(command.measured);  // before hours are spent
    const Scene& scene = jobs.front().run.plan.scene;
    const auto seconds = [](const GridStudyJob& job) { return job.run.plan.seconds(job.run.method); };
    const auto no_run_fits = [&] {
        return InputError(fmt::format("--budget {}: no run fits; the cheapest needs {}", command.budget,
                                      about_text(seconds(jobs.front()))));
    };
    // before a folder is made
    if (!fs::exists(out) && std::ranges::none_of(jobs, [&](const GridStudyJob& job) { return seconds(job) <= budget; }))
        throw no_run_fits();
    if (!command.making.hand_over && !command.making.collect) {
        say(common, ready_text(scene.run.methods, scene, &jobs.front().run.plan.prediction));
        for (const GridStudyJob& job : jobs)
            if (job.run.plan.scene.fvm.interface != scene.fvm.interface)
                say(common, ready_text({job.run.method}, job.run.plan.scene, &job.run.plan.prediction));
    }
    FolderLock lock(out);
    CampaignRules rules = rules_of(command.making, out);
    rules.overwrite = command.overwrite, rules.budget = budget;
    Campaign campaign(common, rules);
    const Study study{out, common.words, rules.overwrite, rules.take_finished};
    if (command.making.hand_over) return hand_over(command.making, study, campaign, runs_of(jobs), common);
    catch_stop_signals();
    GridStudyHarvest harvest;
    harvest.left_out = plan.left_out;
    ReportEvery pages(command.making, common.words, out, lock);
    campaign.ahead(study, runs_of(jobs));
    for (const GridStudyJob& job : jobs)
        if (!take(harvest, job, campaign.run_or_take(job.run))) {
            complain("grid-convergence study: stopped on request; the same command continues from here");
            return run_failed;
        }
    pages.end();
    harvest.unfinished = campaign.unfinished();
    harvest.drop_lone_variations();
    if (harvest.runs.empty() && harvest.any_failed)
        throw RunError("no run of the grid-convergence study is left: " + harvest.left_out.front());
    if (harvest.runs.empty()) throw no_run_fits();
    report_grid_study(harvest, measured, out, common);
    return harvest.any_failed ? run_failed : done;
}

}  // namespace tw::app
