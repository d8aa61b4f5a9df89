#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/campaign/grid_study_jobs.h"

namespace tw::app {

/// The runs that `run` makes: the scene's own size, sqrt 2 and 2 times its sizes, and one in a wider box.
GridStudySizes sizes_of_coarser_members(RunRequest own);

/// Those but for the scene's own: with it they are a grid study of three sizes, which tells the discretisation error.
/// They leave no snapshots.
class CoarserMembers {
public:
    /// Their folders are `out`/near_hull_.../METHOD. Nothing is thrown for a size that the scene does not allow: it is
    /// left out and named.
    CoarserMembers(RunRequest own, const std::filesystem::path& out);

    std::vector<CampaignRun> runs() const;  ///< those to be made, cheapest first
    std::vector<std::vector<CampaignRun>> by_size() const;  ///< the same, size by size, the coarsest first
    double seconds() const;                 ///< predicted, of those that are not finished [s]
    /// "grid triplet: 4 coarser runs and one in a wider box, about 21 s (+ 31 %); --no-twins leaves them out";
    /// what is left out, and runs not similar to the scene's own, below it. `own`: predicted time of the scene's own
    /// runs [s].
    std::string prediction_text(const Scene& scene, double own) const;

    /// Refuses folders of another scene's runs before hours are spent. Throws InputError.
    void refuse_others() const;
    /// Removes them where they are among `made`, which this call made of sizes that it has given up since.
    void remove_others(const std::set<std::filesystem::path>& made) const;
    /// Runs them, cheapest first; a finished one is taken. False: stopped on request. One that fails is left out.
    bool run(Campaign& campaign);
    /// The grid study of these and the scene's own finished runs in `own`/METHOD, where there are some. CoarserMembers
    /// that an earlier call left for the other method are taken with its record.
    std::optional<GridStudy> grid_study(const std::vector<RunRecord>& records, const std::filesystem::path& own);

private:
    GridStudyPlan plan_;
    std::vector<GridStudyJob> of_other_methods_;
    GridStudyHarvest harvest_;
};

}  // namespace tw::app
