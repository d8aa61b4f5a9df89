#include "app/campaign/empty_twin.h"

#include "app/runs/read_run.h"
#include "scene/empty_twin.h"

namespace tw::app {

std::optional<CampaignRun> empty_twin_of(const CampaignRun& run) {
    if (!wants_empty_twin(run.plan.scene)) return {};
    RunRequest request = run.plan.request;
    request.overrides.empty_twin = true;
    request.snapshots = false;
    return CampaignRun{run.name + " without its bodies", run.method, plan_run(request),
                       folder_of_empty_twin(run.folder)};
}

}  // namespace tw::app
