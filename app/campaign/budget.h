#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/campaign/grid_study_jobs.h"

namespace tw::app {

/// The time that --budget gives [s]; infinity: it is empty. Throws InputError naming the option.
double budget_seconds(const std::string& budget);

/// A family of sizes that a time pays for.
struct PaidSizes {
    double scale = 1;      ///< of all sizes of the scene [-]
    double near_hull = 0;  ///< finest size of the family [m]
    double seconds = 0;    ///< predicted, of all its runs [s]
};
/// The finest family whose predicted time is at most `budget` [s], finer or coarser than the scene's own: its interval
/// is the narrowest, since the sizes of a family are in fixed proportion. Scales are powers of 2^(1/8), of which one is
/// worth a factor of up to 1.4 in time. `family`: its runs, the finest at the scene's own size. Throws InputError: the
/// scene is wrong, or no family that it allows fits.
PaidSizes sizes_for_budget(const GridStudySizes& family, double budget);

/// Of a hull in a stream whose finest size is above a tenth of the beam: that it is, and the budget of a tenth, where
/// the scene allows it. Empty of anything else.
std::string first_impression(const GridStudySizes& family, const PaidSizes& sizes, const Scene& scene);

/// What an earlier call chose for this budget in this folder of results (`out`/sizes.json): a run goes on at its sizes,
/// whatever has been learned of the machine's speed since. None: nothing was chosen there. Throws InputError: it was for
/// another budget, or the file is damaged.
std::optional<PaidSizes> remembered_sizes(const std::filesystem::path& out, double budget);
void remember(const PaidSizes& sizes, double budget, const std::filesystem::path& out);

}  // namespace tw::app
