#pragma once
#include <filesystem>

#include "foam_cases/case_plan.h"

namespace tw {

/// Writes alpha.water and U of the time folder as the scene's wave has them at the start: in each cell the share of its
/// volume below the surface, and the velocity at its middle; in air that at the surface's height, which leaves no step
/// there. The folder has cell centres and volumes.
void begin_with_wave(const CasePlan& plan, const std::filesystem::path& time_folder);

}  // namespace tw
