#include "app/campaign/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/arguments/output.h"
#include "app/campaign/side_by_side.h"
#include "app/pace/jobs_by_default.h"
#include "app/progress/run_told.h"
#include "app/runs/read_run.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "scene/cost/program_memory.h"
#include "scene/hash.h"
#include "scene/run/run_end.h"
#include "sph_solver/parallel/comm.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// The record of an earlier run of the very same scene and numerics, however it ended.
std::optional<RunRecord> record_of(const CampaignRun& run) {
    const fs::path file = run.folder / "record.h5";
    if (!fs::exists(file)) return {};
    RunRecord record = read_run(file);
    if (record.attributes["run_hash"] != run_hash(run.plan.scene, run.method)) return {};
    return record;
}

/// The record of an earlier run of the very same scene and numerics in this folder, if it is finished.
std::optional<RunRecord> finished_run(const CampaignRun& run) {
    std::optional<RunRecord> record = record_of(run);
    // the duration is not in the hash: a run may be made longer
    const bool finished = record && is_complete(run.plan.scene, *record);
    return finished ? std::move(record) : std::nullopt;
}

/// A run of the very same scene and numerics that failed before it saved a state: nothing to resume.
bool failed_before_it_saved(const CampaignRun& run) {
    if (fs::exists(run.folder / solver_of(run.method).state)) return false;
    const std::optional<RunRecord> record = record_of(run);
    return record && record->state == "failed";
}

/// Leaves the list of the runs that are made here one after another for those who watch them; not being able to is no
/// failure.
void tell_runs(const fs::path& out, const std::vector<CampaignRun>& runs) {
    RunsList list{ProcessName::own(), seconds_since_1970()};
    for (const CampaignRun& run : runs)
        list.runs.push_back(
            {run.name, fs::absolute(run.folder).lexically_relative(fs::absolute(out)), run.plan.seconds(run.method)});
    replace_quietly(out / runs_list_file, json_of(list));
}

Member member_of(const CampaignRun& run) {
    const MethodCost& cost = run.plan.prediction.of(run.method);
    Member member{run.name,     run.method, run.folder, run.plan.request, cost.seconds, all_bytes(run.plan.scene, cost),
                  cost.elements};
    member.request.threads = run.plan.scene.run.threads;
    member.request.ranks = run.ranks();
    return member;
}

/// By the pace of this machine.
JobCost cost_on_one_core(const std::string& method, const Scene& scene, int cores) {
    Scene alone = scene;
    alone.run.threads = 1;
    const MethodCost cost = predict_here(alone).of(method);
    const double least = solver_of(method).elements_per_rank;
    const double of_it = least > 0 ? std::clamp(std::floor(cost.elements / least), 1.0, double(cores)) : cores;
    return {cost.seconds, all_bytes(alone, cost), of_it, least == 0};
}

}  // namespace

int CampaignRun::ranks() const { return solver_of(method).elements_per_rank > 0 ? 1 : plan.scene.run.ranks; }

bool is_finished(const CampaignRun& run) { return finished_run(run).has_value(); }

CampaignRules rules_of(const Making& making, const fs::path& out) {
    CampaignRules rules;
    rules.jobs = making.jobs;
    if (making.collect) rules.collect = out;
    return rules;
}

std::string Campaign::over_budget(double cost) const {
    if (spent_ + cost <= rules_.budget) return {};
    return fmt::format("left out, {} more; the budget is {} and {} of it are used", about_text(cost),
                       time_text(rules_.budget), time_text(spent_));
}

std::vector<CampaignRun> Campaign::to_make(const std::vector<CampaignRun>& runs) {
    std::vector<CampaignRun> made;
    for (const CampaignRun& run : runs) {
        if (rules_.take_finished && is_finished(run)) continue;
        const double cost = run.plan.seconds(run.method);
        if (const std::string why = over_budget(cost); !why.empty()) {
            say(common_, run.name + ": " + why + "\n");
            known_[run.folder] = {CampaignResult::State::over_budget, {}, why};
        } else {
            spent_ += cost;
            made.push_back(run);
        }
    }
    return made;
}

Sharing Campaign::sharing_of(const std::vector<CampaignRun>& made) const {
    if (rules_.jobs > 0) return {rules_.jobs};
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<JobCost> costs;
    for (const CampaignRun& run : made) {
        const Scene& scene = run.plan.scene;
        if (scene.run.threads > 0 || scene.run.ranks > 1 || scene.run.device != "cpu") return {};
        costs.push_back(cost_on_one_core(run.method, scene, cores));
    }
    const SideBySideChoice choice = jobs_by_default(costs, cores, memory_for_jobs());
    if (choice.jobs < 2) return {};
    say(common_, fmt::format("{} runs at a time, each on one core: {} instead of {} one after another (--jobs 1)\n",
                             choice.jobs, about_text(choice.together), about_text(choice.one_by_one)));
    return {choice.jobs, true};
}

void Campaign::ahead(Study study, const std::vector<CampaignRun>& runs) {
    const bool shared = std::ranges::any_of(runs, [](const CampaignRun& r) { return r.ranks() > 1; });
    if (!rules_.collect.empty()) return;
    // a budget is of runs one after another
    const bool one_by_one = rules_.jobs == 1 || (rules_.jobs == 0 && std::isfinite(rules_.budget));
    if (one_by_one && !shared) return tell_runs(study.out, runs);
    std::vector<CampaignRun> made = runs;
    if (rules_.take_finished) std::erase_if(made, is_finished);
    const Sharing sharing = one_by_one ? Sharing{} : sharing_of(made);
    if (sharing.jobs < 2 && !shared) return tell_runs(study.out, runs);
    std::error_code ignored;  // of an earlier command: these runs are the study's, which tells more
    fs::remove(study.out / runs_list_file, ignored);
    made = to_make(made);
    for (const CampaignRun& run : made) study.members.push_back(member_of(run));
    const std::vector<MemberState> states = run_side_by_side(study, sharing, common_);
    for (std::size_t k = 0; k < made.size(); ++k) {
        using State = CampaignResult::State;
        const MemberState& state = states[k];
        State became = State::failed;
        if (state.kind == MemberState::Kind::done) became = State::done;
        if (state.kind == MemberState::Kind::stopped || state.kind == MemberState::Kind::waiting)
            became = State::stopped;
        if (state.kind == MemberState::Kind::refused)
            refused_[made[k].folder] = state.why;
        else
            known_[made[k].folder] = {became, {}, state.why};
        any_failed_ |= state.kind == MemberState::Kind::failed;
    }
}

int hand_over(const Making& making, Study study, Campaign& campaign, const std::vector<CampaignRun>& runs,
              const Common& common) {
    if (runs.empty()) throw InputError(study.out.string() + ": none of its scenes can be run; each says why above");
    for (const CampaignRun& run : campaign.to_make(runs)) study.members.push_back(member_of(run));
    return making.hand_over(std::move(study), common);
}

CampaignResult Campaign::collect(const CampaignRun& run) {
    using State = CampaignResult::State;
    if (std::optional<RunRecord> finished = finished_run(run)) return {State::taken, std::move(finished), {}};
    const std::optional<RunRecord> begun = record_of(run);
    const std::string why =
        begun && begun->state == "failed" ? begun->reason : why_unfinished(rules_.collect, run.folder);
    any_failed_ = true;
    if (!begun || begun->state != "failed") unfinished_.push_back(run.name);
    complain(run.name + ": not finished: " + why);
    return {State::failed, {}, why};
}

CampaignResult Campaign::run_or_take(CampaignRun run) {
    using State = CampaignResult::State;
    if (!rules_.collect.empty()) return collect(run);
    if (const auto why = refused_.find(run.folder); why != refused_.end()) throw InputError(why->second);
    if (const auto found = known_.find(run.folder); found != known_.end()) {
        CampaignResult result = found->second;
        if (result.state == State::done) result.record = read_run(run.folder / "record.h5");
        return result;
    }
    if (std::optional<RunRecord> earlier = rules_.take_finished ? finished_run(run) : std::nullopt) {
        say(common_, fmt::format("{}: finished before, taken from {}\n", run.name, run.folder.string()));
        return {State::taken, std::move(earlier), {}};
    }
    run.plan.prediction = predict_here(run.plan.scene);  // the runs before have taught the pace
    const double cost = run.plan.seconds(run.method);
    if (const std::string why = over_budget(cost); !why.empty()) {
        say(common_, run.name + ": " + why + "\n");
        return {State::over_budget, {}, why};
    }
    say(common_, fmt::format("{}: {}\n", run.name, about_text(cost)));
    const bool anew = rules_.overwrite || failed_before_it_saved(run);
    const bool resume = fs::exists(run.folder) && !anew;
    Comm::world().together([] {});  // all processes of the run have looked before one of them writes
    const auto start = std::chrono::steady_clock::now();
    const auto charge = [&] {
        spent_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    try {
        RunRecord record = run_method(run.method, run.plan, {run.folder, resume, anew, rules_.progress}, common_);
        charge();
        say(common_, run.name + ": " + closing_line(facts_of(run.method, record, run.folder)));
        if (record.state != "finished" || stop_asked()) return {State::stopped, std::move(record), {}};
    } catch (const RunError& e) {
        charge();
        if (!fs::exists(run.folder)) throw;  // moved away or removed: what follows would make it anew
        any_failed_ = true;
        complain(run.name + ": failed: " + e.what());
        return {State::failed, {}, e.what()};
    }
    return {State::done, read_run(run.folder / "record.h5"), {}};
}

}  // namespace tw::app
