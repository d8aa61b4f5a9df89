#pragma once
#include <string>
#include <vector>

#include "foam_cases/openfoam.h"
#include "foam_cases/run/child.h"

namespace tw {

/// The words that stand before each OpenFOAM program, of $TWINWAKE_OPENFOAM_PREFIX with blanks between: "apptainer exec
/// /sw/of.sif openfoam2506". A program behind them runs where that OpenFOAM is, in a container for instance. They are the
/// user's, never a scene's: a scene that comes from somebody else names no command. No shell reads them.
std::vector<std::string> openfoam_prefix();

/// `program` and its arguments behind the prefix, whose first word is looked for on the PATH of the environment. Throws
/// RunError where it is not there.
Command behind(const std::vector<std::string>& prefix, const std::string& program,
               const std::vector<std::string>& arguments, const std::vector<std::string>& environment);

/// The OpenFOAM there, by WM_PROJECT_DIR, WM_PROJECT_VERSION and FOAM_APPBIN of the environment behind the prefix. It is
/// not tested yet; where the words lead to none, `verdict` says what was found and what is wanted.
OpenFoam openfoam_behind(const std::vector<std::string>& prefix);

}  // namespace tw
