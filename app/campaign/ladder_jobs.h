#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/campaign/campaign.h"
#include "app/campaign/write_ladder.h"

namespace tw::app {

/// A choice that should not matter, made otherwise in one run.
struct LadderChoice {
    const char *method, *name, *folder;  ///< method: "sph", "fvm"; "": the cheaper one
    void (*make)(SceneOverrides& overrides);
    double share;      ///< of the error, see LadderVariation
    double steps = 1;  ///< how many times as many time steps it is to take
    bool box = false;
};

/// One run of a ladder.
struct LadderJob {
    CampaignRun run;
    const LadderChoice* choice = nullptr;  ///< none: a size
    bool fills_in = false;                 ///< a size between two others
};

/// Which sizes of a scene are run, and how.
struct LadderSizes {
    RunRequest request;         ///< of the scene's own size
    int first = 0, levels = 4;  ///< sizes near_hull ratio^k, k from `first` to `levels` - 1
    double ratio = 1.4142135623730951;
    bool variations = true;  ///< other sound speed, time step and Courant number, at the second coarsest size
    bool surface = false;    ///< the water's surface captured geometrically, at the same size
    bool box = true;         ///< a wider box at the coarsest size, where the scene is open water
    /// Of four sizes and more also near_hull ratio^(k + 1/2), between neighbouring ones but for the two finest.
    bool fill = false;
};

/// The runs of a ladder, cheapest first; behind them all the sizes that fill in, cheapest first: a budget leaves them out
/// before any other that fits.
struct LadderPlan {
    std::vector<LadderJob> jobs;
    std::vector<std::string> left_out;  ///< coarser sizes that the scene does not allow, and why
};
/// Throws InputError: the scene is wrong at its own size, if that is one of them.
LadderPlan plan_ladder(const LadderSizes& sizes, const std::filesystem::path& out);

std::vector<CampaignRun> runs_of(const std::vector<LadderJob>& jobs);

/// Takes one run into the ladder. False: stopped on request. One that fails, or does not fit a budget, is left out and
/// named in the report; the others are run all the same.
bool take(LadderHarvest& harvest, const LadderJob& job, CampaignResult result);

}  // namespace tw::app
