#pragma once
#include <optional>

#include "app/campaign/campaign.h"

namespace tw::app {

/// The run of a scene's empty twin beside a run with bodies; none: the scene does not want it
/// (scene/empty_twin.h). It leaves no snapshots. Throws InputError as plan_run.
std::optional<CampaignRun> empty_twin_of(const CampaignRun& run);

}  // namespace tw::app
