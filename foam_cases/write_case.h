#pragma once
#include <filesystem>

#include "foam_cases/case_plan.h"

namespace tw {

/// Writes every file of the case and the solids' surfaces. Throws RunError where a file cannot be written, and
/// std::filesystem::filesystem_error where a folder cannot be made.
void write_case(const CasePlan& plan, const std::filesystem::path& folder, int ranks);
/// Name of the first file that `plan` would write otherwise than it stands in `folder` (system/controlDict and the
/// number of ranks aside); empty when there is none: the run in the folder can be resumed. Throws InputError where a
/// file that is there cannot be read.
std::string changed_file(const CasePlan& plan, const std::filesystem::path& folder);

/// Only writes the case, for an OpenFOAM user to run by hand (./Allrun).
void write_fvm_case(const Scene& scene, const std::filesystem::path& folder);

}  // namespace tw
