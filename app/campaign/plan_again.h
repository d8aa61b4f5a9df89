#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/campaign/budget.h"
#include "app/campaign/campaign.h"

namespace tw::app {

/// What the coarsest runs of a study say about a budget, before the dear ones are begun.
struct Trial {
    bool stopped = false;            ///< on request
    std::optional<PaidSizes> sizes;  ///< coarser ones that what is left pays for; none: go on
    std::string said;                ///< why, or why not though time will be short; with a line end, or empty
};

/// Makes the runs of `by_size`, size by size from the coarsest on, until those of one size took so much longer than they
/// are predicted to take now that the study would take more than 1.15 times its budget. `all`: every run of the study;
/// runs that took less than a fiftieth of the budget say nothing, since they have mostly started and ended.
Trial try_coarsest(const std::vector<std::vector<CampaignRun>>& by_size, const std::vector<CampaignRun>& all,
                   const GridStudySizes& family, const PaidSizes& now, double budget, Campaign& campaign);

}  // namespace tw::app
