#pragma once
#include <optional>

#include "app/campaign/campaign.h"

namespace tw::app {

/// The run of a scene's twin, without its bodies or without the wave, beside the run itself; none: the scene does not want
/// it (scene/wave_twin.h). It leaves no snapshots. Throws InputError as plan_run.
std::optional<CampaignRun> wave_twin_of(const CampaignRun& run);

}  // namespace tw::app
