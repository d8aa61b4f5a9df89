#include "app/campaign/wave_twin.h"

#include "scene/wave_twin.h"

namespace tw::app {

std::optional<CampaignRun> wave_twin_of(const CampaignRun& run) {
    if (!wants_wave_twin(run.plan.scene)) return {};
    RunRequest request = run.plan.request;
    request.overrides.wave_twin = true;
    request.snapshots = false;
    return CampaignRun{run.name + " without " + left_out_of_twin(run.plan.scene), run.method, plan_run(request),
                       run.folder.parent_path() / folder_of_wave_twin(run.plan.scene) / run.folder.filename()};
}

}  // namespace tw::app
