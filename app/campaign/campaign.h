#pragma once
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/campaign/side_by_side.h"
#include "app/runs/run_method.h"

namespace tw::app {

/// One method's run in a folder of its own, as run, grid study, sweep and ablate need it.
struct CampaignRun {
    std::string name;  ///< for people: "sph", "sph at 0.02 m", "6 m/s: fvm"
    std::string method;
    PlannedRun plan;
    std::filesystem::path folder;

    int ranks() const;  ///< processes that share it; of the mesh method 1, which starts its own
};

/// How a run ended.
struct CampaignResult {
    enum class State {
        taken,        ///< finished before
        done,         ///< run now, or resumed
        failed,       ///< begun, and not finished: `why_not`
        over_budget,  ///< not begun: `why_not`
        stopped       ///< on request, with its state saved
    };
    State state = State::failed;
    std::optional<RunRecord> record;  ///< as it lies on disk; taken, done and stopped
    std::string why_not;

    bool there() const { return state == State::taken || state == State::done; }
};

struct CampaignRules {
    bool overwrite = false;  ///< what is no finished run of the very same scene and numerics is run anew, not refused
    bool take_finished = true;                                ///< false: a finished run, too, is run anew
    double budget = std::numeric_limits<double>::infinity();  ///< predicted time of everything that is run here [s]
    int jobs = 1;  ///< runs side by side; 0: by default, see jobs_by_default.h
    /// Nothing is run: what is not finished counts as failed. The study's folder of results; empty: it is run.
    std::filesystem::path collect = {};
    std::function<void(const Progress&)> progress = {};  ///< called with the progress of every run made here
};

/// The rules that follow from how the study is made.
CampaignRules rules_of(const Making& making, const std::filesystem::path& out);

/// The one way to a finished run. A campaign is any number of them under one budget: one after the other, or ahead of
/// that side by side, or each as processes of its own because several share it.
class Campaign {
public:
    explicit Campaign(const Common& common, CampaignRules rules = {}) : common_(common), rules_(std::move(rules)) {}

    /// Of these, what is not finished and fits the budget by its predicted time; the others of the budget are left out
    /// from now on.
    std::vector<CampaignRun> to_make(const std::vector<CampaignRun>& runs);
    /// Where runs are made by other processes: makes those of the study, whose members follow from `runs`, so that
    /// run_or_take finds them. Else leaves a list of the runs in the study's folder, for those who watch it.
    void ahead(Study study, const std::vector<CampaignRun>& runs);

    /// Takes the record if the run is finished there, by run hash and duration; else resumes it if it was stopped, or
    /// runs it, as far as the budget goes, and reads the record back. A run that failed before it saved a state has
    /// nothing to resume and is run anew. A failure is said on standard error, returned, and charged to the budget.
    /// Throws InputError: the folder holds another scene's run.
    CampaignResult run_or_take(CampaignRun run);

    double spent() const { return spent_; }  ///< wall time of the runs made here, failed ones included [s]
    bool any_failed() const { return any_failed_; }
    /// Where nothing is run here (`collect`): the names of the runs that are not finished and have not failed.
    const std::vector<std::string>& unfinished() const { return unfinished_; }

private:
    Sharing sharing_of(const std::vector<CampaignRun>& made) const;
    CampaignResult collect(const CampaignRun& run);
    std::string over_budget(double cost) const;

    const Common& common_;
    CampaignRules rules_;
    std::map<std::filesystem::path, CampaignResult> known_;  ///< by folder: what became of it ahead; without records
    std::map<std::filesystem::path, std::string> refused_;   ///< what is wrong with the input of others
    double spent_ = 0;
    bool any_failed_ = false;
    std::vector<std::string> unfinished_;
};

/// Gives the study with those of its runs that are still to be made to `making.hand_over`. Returns the exit status.
int hand_over(const Making& making, Study study, Campaign& campaign, const std::vector<CampaignRun>& runs,
              const Common& common);

/// Whether the folder holds a finished run of this scene and these numerics.
bool is_finished(const CampaignRun& run);

}  // namespace tw::app
