#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/campaign/campaign.h"
#include "app/campaign/write_grid_study.h"

namespace tw::app {

/// A choice that should not matter, made otherwise in one run.
struct GridStudyChoice {
    std::string method, name, folder;  ///< method: "sph", "fvm"; "": the cheaper one
    std::function<void(RunRequest& request)> make;
    double share = 1;  ///< of the error, see GridStudyVariation [-]
    double steps = 1;  ///< how many times as many time steps it is to take [-]
    bool box = false;
    std::string input = {};  ///< name of the uncertain number that lies at an end of its interval
};

/// One run of a grid study.
struct GridStudyJob {
    CampaignRun run;
    std::optional<GridStudyChoice> choice = {};  ///< none: a size
    bool fills_in = false;                    ///< a size between two others
    bool is_wave_twin() const { return !run.plan.scene.wave_twin_of.empty(); }
};

/// Which sizes of a scene are run, and how.
struct GridStudySizes {
    RunRequest request;                 ///< of the scene's own size
    int first = 0, levels = 4;          ///< sizes near_hull ratio^k, k from `first` to `levels` - 1
    double ratio = 1.4142135623730951;  ///< of neighbouring spacings [-]
    bool variations = true;  ///< other sound speed, time step and Courant number, at the second coarsest size
    bool surface = false;    ///< the water's surface captured geometrically, at the same size
    bool box = true;         ///< a wider box at the coarsest size, where the scene is open water
    bool input = true;       ///< either end of every uncertain number of the scene, at the coarsest size
    std::optional<UncertainTable> uncertain = {};  ///< beside those of the scene
    /// Of four sizes and more also near_hull ratio^(k + 1/2), between neighbouring ones but for the two finest.
    bool fill = false;
};

/// The runs of a grid study, cheapest first; behind them all the sizes that fill in, cheapest first: a budget leaves
/// them out before any other that fits.
struct GridStudyPlan {
    std::vector<GridStudyJob> jobs;
    std::vector<std::string> left_out;  ///< coarser sizes that the scene does not allow, and why
};
/// Throws InputError: the scene is wrong at its own size, if that is one of them.
GridStudyPlan plan_grid_study(const GridStudySizes& sizes, const std::filesystem::path& out);

std::vector<CampaignRun> runs_of(const std::vector<GridStudyJob>& jobs);

/// The run of a choice as the grid study takes it.
GridStudyVariation variation_of(const GridStudyChoice& choice, GridStudyRun run);

/// What a run with an uncertain number at an end of its interval is, by the folder it was made in,
/// SIZE/SECTION.KEY_high/METHOD; none: another run.
std::optional<GridStudyVariation> uncertain_input_of(const std::filesystem::path& record_file, const GridStudyRun& run);

/// Takes one run into the grid study. False: stopped on request. One that fails, or does not fit a budget, is left out
/// and named in the report; the others are run all the same.
bool take(GridStudyHarvest& harvest, const GridStudyJob& job, CampaignResult result);

}  // namespace tw::app
