#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/campaign/campaign.h"
#include "app/campaign/grid_study_jobs.h"
#include "suite/suite.h"

namespace tw::app {

/// All runs of one scene of a case.
struct PlannedScene {
    const SuiteScene* scene = nullptr;
    std::vector<std::string> methods;  ///< that are run
    double near_hull = 0;              ///< of the scene's own size [m]
    GridStudyPlan plan = {};

    std::vector<CampaignRun> runs() const { return runs_of(plan.jobs); }
};

struct PlannedCase {
    const SuiteCase* of = nullptr;
    std::string why_not;  ///< why none of it is run: its tier, its method, a scene that is wrong
    bool wrong = false;   ///< of these the last
    std::vector<PlannedScene> scenes;
    /// Of each of its quantities by method what a value is made for, whether it is run or not. What cannot be read is
    /// not known; where that is run, `why_not` says why.
    std::vector<std::map<std::string, ValueBasis>> bases;
};

/// What is asked of a suite's cases.
struct ValidationRules {
    std::string tier, method;        ///< the dearest tier; the method, or every_method, or empty: as the case says
    std::vector<std::string> cases;  ///< names; empty: all
    int threads = 0;
    bool elsewhere = false;
};
/// A case whose scene is wrong is reported and left out; the others are run all the same.
PlannedCase plan_case(const SuiteCase& of, const ValidationRules& rules, const std::filesystem::path& out);

/// Makes or takes the case's runs and judges what they gave. Nothing: stopped on request. A truth that the
/// measured file does not hold is complained of, and the value left without a verdict.
std::optional<ValidatedCase> judge_case(const PlannedCase& planned, Campaign& campaign,
                                        const std::filesystem::path& out);

}  // namespace tw::app
