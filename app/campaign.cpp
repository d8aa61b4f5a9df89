#include "app/campaign.h"

#include <fmt/format.h>

#include <chrono>

#include "app/output.h"
#include "app/solvers.h"
#include "app/stop_signal.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "scene/hash.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// The record of an earlier run of the very same scene and numerics in this folder, if it is finished.
std::optional<RunRecord> finished_run(const CampaignRun& run) {
    const fs::path file = run.folder / "record.h5";
    if (!fs::exists(file)) return {};
    RunRecord record = read_record(file);
    // the duration is not in the hash: a run may be made longer
    const bool same = record.state == "finished" &&
                      record.attributes["run_hash"] == run_hash(run.plan.scene, run.method) &&
                      record.numbers["duration"] >= run.plan.scene.run.duration;
    return same ? std::optional(std::move(record)) : std::nullopt;
}

/// A run of the very same scene and numerics that failed before it saved a state: nothing to resume.
bool failed_before_it_saved(const CampaignRun& run) {
    if (fs::exists(run.folder / solver_of(run.method).state)) return false;
    if (!fs::exists(run.folder / "record.h5")) return false;
    RunRecord record = read_record(run.folder / "record.h5");
    return record.state == "failed" && record.attributes["run_hash"] == run_hash(run.plan.scene, run.method);
}

}  // namespace

bool is_finished(const CampaignRun& run) { return finished_run(run).has_value(); }

CampaignResult Campaign::run_or_take(CampaignRun run) {
    using State = CampaignResult::State;
    if (std::optional<RunRecord> earlier = rules_.take_finished ? finished_run(run) : std::nullopt) {
        say(common_, fmt::format("{}: finished before, taken from {}\n", run.name, run.folder.string()));
        return {State::taken, std::move(earlier), {}};
    }
    run.plan.prediction = predict_here(run.plan.scene);  // the runs before have taught the pace
    const double cost = run.plan.seconds(run.method);
    if (spent_ + cost > rules_.budget) {
        const std::string why = fmt::format("left out, {} more; the budget is {} and {} of it are used",
                                            about_text(cost), time_text(rules_.budget), time_text(spent_));
        say(common_, run.name + ": " + why + "\n");
        return {State::over_budget, {}, why};
    }
    say(common_, fmt::format("{}: {}\n", run.name, about_text(cost)));
    const bool anew = rules_.overwrite || failed_before_it_saved(run);
    const bool resume = fs::exists(run.folder) && !anew;
    const auto start = std::chrono::steady_clock::now();
    const auto charge = [&] {
        spent_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    try {
        RunRecord record = run_method(run.method, run.plan, {run.folder, resume, anew}, common_);
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
    return {State::done, read_record(run.folder / "record.h5"), {}};
}

}  // namespace tw::app
