#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "foam_cases/openfoam.h"

namespace tw {

/// Environment in which programs of an installation run in `folder`: the caller's, without what another release has put
/// there, with WM_PROJECT_DIR, PATH and LD_LIBRARY_PATH of that installation in front, in place of sourcing its shell
/// scripts.
std::vector<std::string> environment_of(const OpenFoam& openfoam, const std::filesystem::path& folder);

/// First program of that name on the PATH of the environment; empty when there is none.
std::filesystem::path find_program(const std::vector<std::string>& environment, const std::string& name);

}  // namespace tw
