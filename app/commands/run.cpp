#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "app/arguments/output.h"
#include "app/campaign/budget.h"
#include "app/campaign/campaign.h"
#include "app/campaign/coarser_members.h"
#include "app/campaign/plan_again.h"
#include "app/campaign/report_every.h"
#include "app/campaign/wave_twin.h"
#include "app/runs/body_outcome.h"
#include "app/runs/facts_json.h"
#include "app/runs/ranks.h"
#include "app/runs/read_run.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/compare.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "methods/names.h"
#include "scene/doubtful_input.h"
#include "scene/hash.h"
#include "sph_solver/parallel/comm.h"
#include "text/plain_number.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// In this order, whatever the scene's.
std::vector<std::string> methods_of(const Scene& scene) {
    std::vector<std::string> methods;
    for (const std::string& method : method_names())
        if (std::ranges::find(scene.run.methods, method) != scene.run.methods.end()) methods.push_back(method);
    return methods;
}

/// When a file was written last; of one that is not there the clock's first moment.
fs::file_time_type last_written(const fs::path& file) {
    std::error_code none;
    const fs::file_time_type time = fs::last_write_time(file, none);
    return none ? fs::file_time_type::min() : time;
}

/// A folder that holds a run is refused before another method spends an hour.
void refuse_taken(const fs::path& folder, const std::string& method, const RunCommand& command) {
    if (command.making.collect) return;
    const bool taken = fs::exists(folder / "record.h5") || fs::exists(folder / solver_of(method).state);
    if (taken && !command.resume && !command.overwrite)
        throw InputError(
            fmt::format("{}: there is a run already; continue it with --resume, run anew with --overwrite, or choose "
                        "another folder with --out",
                        folder.string()));
}

/// "SPH: 45600 particles, about 2 min": of the methods that will run.
std::string prediction_text(const PlannedRun& plan) {
    std::string text;
    for (const std::string& method : methods_of(plan.scene)) {
        const MethodCost& cost = plan.prediction.of(method);
        text += fmt::format("{}: {} {}, {}{}\n", method_label(method), plain_number(cost.elements), elements_of(method),
                            plan.scene.run.stops_when_settled() ? "at most " : "", about_text(cost.seconds));
    }
    return text;
}

/// Of the scene's own size.
std::vector<CampaignRun> wave_twins_of(const PlannedRun& plan, const fs::path& out) {
    std::vector<CampaignRun> runs;
    for (const std::string& method : methods_of(plan.scene))
        if (std::optional<CampaignRun> twin = wave_twin_of({method_label(method), method, plan, out / method}))
            runs.push_back(std::move(*twin));
    return runs;
}

/// The runs whose sizes --budget chooses.
GridStudySizes family_of(const RunCommand& command, const RunRequest& own) {
    GridStudySizes family = sizes_of_coarser_members(own);
    if (!command.coarser_members) family.levels = 1;
    return family;
}

/// What --budget chooses, or chose when the run was begun; none: it is not given.
std::optional<PaidSizes> paid_sizes(const RunCommand& command, const RunRequest& own, const fs::path& out) {
    if (command.budget.empty()) return {};
    const double budget = budget_seconds(command.budget);
    std::optional<PaidSizes> sizes;
    if (!command.overwrite) sizes = remembered_sizes(out, budget);
    return sizes ? sizes : sizes_for_budget(family_of(command, own), budget);
}

std::string budget_text(const RunCommand& command, const PlannedRun& plan, const PaidSizes& paid) {
    return fmt::format("budget of {}: near_hull = {} m, {} times the scene's size, with all runs {}\n",
                       time_text(budget_seconds(command.budget)), plain_number(paid.near_hull),
                       plain_number(paid.scale), about_text(paid.seconds)) +
           first_impression(family_of(command, plan.request), paid, plan.scene);
}

/// What lies in the run's folder of this very scene: another scene's record beside it would mislead.
std::vector<RunRecord> records_of(const Scene& scene, const fs::path& out, const Common& common) {
    std::vector<RunRecord> records;
    const std::vector<std::string> now = methods_of(scene);
    for (const std::string& method : method_names()) {
        const fs::path file = out / method / "record.h5";
        if (!fs::exists(file)) continue;
        RunRecord record = read_run(file);
        const bool run_now = std::ranges::find(now, method) != now.end();
        if (run_now ? record.attributes["run_hash"] == run_hash(scene, method)
                    : record.attributes["scene_hash"] == scene.hash)
            records.push_back(std::move(record));
        else
            say(common, fmt::format("{}: of another scene than this run, left out of the report\n", file.string()));
    }
    return records;
}

/// The exit status of --require agree.
int required_agreement(const std::optional<GridStudy>& grid_study) {
    const std::string others = grid_study ? not_agreeing(*grid_study)
                                          : "without the coarser runs (twins) the discretisation error is not known";
    if (others.empty()) return done;
    complain("--require agree is not met: " + others);
    return not_agreed;
}

struct Made {
    std::vector<RunFacts> runs;
    bool failed = false;
    std::vector<std::string> unfinished = {};  ///< names of the runs that somebody else still makes
};

/// Compares what lies in the run's folder and writes the report; gives the exit status. `coarser_members`: null: none
/// were run.
int report(const PlannedRun& plan, const RunCommand& command, const Common& common, const fs::path& out,
           const Made& made, CoarserMembers* coarser_members) {
    const Scene& scene = plan.scene;
    std::vector<RunRecord> records = records_of(scene, out, common);
    if (records.empty()) {
        write_json(common, runs_json(made.runs));
        return made.failed ? run_failed : done;
    }
    const std::optional<GridStudy> grid_study =
        coarser_members ? coarser_members->grid_study(records, out) : std::nullopt;
    Comparison comparison = compare_records(std::move(records));
    if (grid_study) {
        judge_by_sizes(comparison, *grid_study);
        write_tables(*grid_study, out);
    }
    if (const std::string banner = provisional_banner(made.unfinished); !banner.empty())
        comparison.banners.insert(comparison.banners.begin(), banner);
    const ReportFiles files =
        leaving_files([&] { return write_report(comparison, out, grid_study ? grid_study_html(*grid_study) : ""); });
    say(common, "\n" + summary_text(comparison) + "\nreport: " + files.html.string() + "\n");
    write_json(common, run_json(comparison, made.runs, grid_study ? &*grid_study : nullptr));
    if (made.failed) return run_failed;
    return command.require_agree ? required_agreement(grid_study) : done;
}

/// One run of the particles that all processes make together. The first one speaks and writes.
int run_together(const PlannedRun& plan, const RunCommand& command, const Common& common, const fs::path& out) {
    const Comm& ranks = Comm::world();
    refuse_unshared(plan, command);
    const fs::path folder = out / sph_method;
    std::optional<FolderLock> lock;
    ranks.on_first([&] { lock.emplace(out); });
    ranks.together([&] { refuse_taken(folder, sph_method, command); });
    Common own = common;
    if (!ranks.first()) own.quiet = true, own.json.clear();
    std::string ready;
    ranks.together([&] { ready = ready_text({sph_method}, plan.scene, &plan.prediction); });
    say(own, ready);
    say(own, fmt::format("{}\n{}{}{} ranks, results in {}\n", plan.scene.title, warnings_text(plan.scene),
                         prediction_text(plan), ranks.size(), out.string()));
    catch_stop_signals();
    const RunRecord record = run_method(sph_method, plan, {folder, command.resume, command.overwrite}, own);
    const RunFacts facts = facts_of(sph_method, record, folder);
    say(own, method_label(sph_method) + ": " + closing_line(facts));
    if (record.state != "finished") return run_failed;
    return ranks.first() ? report(plan, command, own, out, {{facts}, false}, nullptr) : static_cast<int>(done);
}

/// The particles' run on ranks that this process starts; nothing: the run is not of that kind, and is made here.
std::optional<int> run_shared(const PlannedRun& plan, const RunCommand& command, const fs::path& out) {
    if (plan.scene.run.ranks < 2 || command.making.collect) return {};
    refuse_unshared(plan, command);
    if (command.making.hand_over || command.coarser_members || methods_of(plan.scene).size() > 1) return {};
    const fs::path folder = out / sph_method, record = folder / "record.h5";
    refuse_taken(folder, sph_method, command);
    return run_on_ranks(plan.scene.run.ranks, [&, before = last_written(record)] {
        const bool anew = last_written(record) != before;
        return (command.resume || anew) && is_finished({method_label(sph_method), sph_method, plan, folder});
    });
}

/// Title, warnings, and what will be run with its predicted time.
std::string announcement(const PlannedRun& plan, const std::string& budget, const std::vector<CampaignRun>& empty,
                         const CoarserMembers* coarser_members, const fs::path& out) {
    double own = 0;
    for (const std::string& method : methods_of(plan.scene)) own += plan.seconds(method);
    std::string of_empty;
    for (const CampaignRun& run : empty)
        of_empty += fmt::format("{}: {}\n", run.name, about_text(run.plan.seconds(run.method)));
    return fmt::format("{}\n{}{}{}{}{}results in {}\n", plan.scene.title, warnings_text(plan.scene), budget,
                       prediction_text(plan), of_empty,
                       coarser_members ? coarser_members->prediction_text(plan.scene, own) : "", out.string());
}

/// The coarser runs, the twins without wave or bodies, then each method's own run. Nothing: stopped on request, which is
/// said.
std::optional<Made> make_all(const PlannedRun& plan, const Common& common, const fs::path& out,
                             const std::vector<CampaignRun>& empty, CoarserMembers* coarser_members,
                             Campaign& campaign) {
    Made made;
    const auto stopped = [&](const std::string& what) {
        complain(what + ": stopped on request; continue it with --resume");
        write_json(common, runs_json(made.runs));
        return std::nullopt;
    };
    if (coarser_members && !coarser_members->run(campaign)) return stopped("coarser runs");
    for (const CampaignRun& run : empty)
        if (campaign.run_or_take(run).state == CampaignResult::State::stopped) return stopped(run.name);
    for (const std::string& method : methods_of(plan.scene)) {
        const CampaignResult result = campaign.run_or_take({method_label(method), method, plan, out / method});
        made.failed |= result.state == CampaignResult::State::failed;  // the other methods run all the same
        if (result.record) {
            made.runs.push_back(facts_of(method, *result.record, out / method));
            say(common, outcome_of_bodies(plan.scene, *result.record));
        }
        if (result.state == CampaignResult::State::stopped) return stopped(method_label(method));
    }
    made.failed |= campaign.any_failed();  // of the coarser members too, and of those without bodies or wave
    made.unfinished = campaign.unfinished();
    return made;
}

/// All runs of one call, and what they follow from.
struct Ordered {
    PlannedRun plan;
    std::optional<CoarserMembers> coarser_members;
    std::vector<CampaignRun> empty;  ///< twins of the scene's own size without bodies or wave

    CoarserMembers* coarser() { return coarser_members ? &*coarser_members : nullptr; }
    std::vector<CampaignRun> all(const fs::path& out) const {
        std::vector<CampaignRun> runs = coarser_members ? coarser_members->runs() : std::vector<CampaignRun>{};
        runs.insert(runs.end(), empty.begin(), empty.end());
        for (const std::string& method : methods_of(plan.scene))
            runs.push_back({method_label(method), method, plan, out / method});
        return runs;
    }
};
/// `made`: folders of the runs that this call has made of other sizes.
Ordered ordered(RunRequest request, PlannedRun plan, const RunCommand& command, const fs::path& out,
                const std::set<fs::path>& made = {}) {
    request.ranks = plan.scene.run.ranks;
    std::vector<CampaignRun> empty = wave_twins_of(plan, out);
    Ordered runs{std::move(plan), {}, std::move(empty)};
    if (command.coarser_members) runs.coarser_members.emplace(request, out / "twins");
    if (runs.coarser_members) runs.coarser_members->remove_others(made);
    if (runs.coarser_members && !command.overwrite) runs.coarser_members->refuse_others();
    return runs;
}

/// Plans again after the coarsest runs, as often as they take too long for the budget. False: stopped on request.
bool keep_to_budget(Ordered& runs, RunRequest& request, PaidSizes& paid, const RunCommand& command,
                    const Common& common, const fs::path& out, Campaign& campaign) {
    const double budget = budget_seconds(command.budget);
    for (;;) {
        const std::vector<CampaignRun> all = runs.all(out);
        campaign.ahead({out, common.words}, all);
        const Trial trial =
            try_coarsest(runs.coarser_members->by_size(), all, family_of(command, request), paid, budget, campaign);
        say(common, trial.said);
        if (!trial.sizes) return !trial.stopped;
        paid = *trial.sizes;
        request.overrides.scale_resolution = paid.scale;
        std::set<fs::path> made;
        for (const CampaignRun& run : all) made.insert(run.folder);
        runs = ordered(request, plan_run(request), command, out, made);
        remember(paid, budget, out);
    }
}

}  // namespace

int run_run(const RunCommand& command, const Common& common) {
    const fs::path out = command.out.empty() ? fs::path("runs") / command.scene.file.stem() : command.out;
    RunRequest request{.file = command.scene.file,
                       .overrides = command.scene.overrides(),
                       .method = command.method,
                       .threads = command.threads,
                       .elsewhere = command.making.elsewhere()};
    std::optional<PaidSizes> paid = paid_sizes(command, request, out);
    if (paid) request.overrides.scale_resolution = paid->scale;
    refuse_report_every(command.making);
    const Comm& started = Comm::world();
    if (!command.making.report_every.empty() && (started.many() || command.ranks > 1))
        throw InputError(
            "--report-every: runs that ranks share are reported at their end; watch them with twinwake watch");
    request.ranks = started.many() ? started.size() : command.ranks;
    PlannedRun plan = plan_run(request);
    const std::vector<std::string> methods = methods_of(plan.scene);

    if (started.many()) return run_together(plan, command, common, out);
    if (const std::optional<int> status = run_shared(plan, command, out)) return *status;
    for (const std::string& method : methods) refuse_taken(out / method, method, command);
    Ordered runs = ordered(request, std::move(plan), command, out);
    const bool made_here = !command.making.hand_over && !command.making.collect;
    if (made_here) say(common, ready_text(methods, runs.plan.scene, &runs.plan.prediction));
    say(common,
        announcement(runs.plan, paid ? budget_text(command, runs.plan, *paid) : "", runs.empty, runs.coarser(), out));

    FolderLock lock(out);
    if (paid) remember(*paid, budget_seconds(command.budget), out);
    CampaignRules rules = rules_of(command.making, out);
    rules.overwrite = command.overwrite, rules.take_finished = !command.overwrite;
    Campaign campaign(common, rules);
    const Study study{out, common.words, rules.overwrite, rules.take_finished};
    if (command.making.hand_over) return hand_over(command.making, study, campaign, runs.all(out), common);

    catch_stop_signals();
    ReportEvery pages(command.making, common.words, out, lock);
    if (paid && made_here && runs.coarser_members && !command.overwrite) {  // else all is run anew behind it
        CampaignRules one_by_one = rules;
        one_by_one.jobs = 1;
        Campaign trial(common, one_by_one);
        if (!keep_to_budget(runs, request, *paid, command, common, out, trial)) {
            complain("coarser runs: stopped on request; continue it with --resume");
            return run_failed;
        }
    }
    campaign.ahead(study, runs.all(out));
    const std::optional<Made> made = make_all(runs.plan, common, out, runs.empty, runs.coarser(), campaign);
    if (!made) return run_failed;
    pages.end();
    return report(runs.plan, command, common, out, *made, runs.coarser());
}

}  // namespace tw::app
