#pragma once
#include <string>
#include <vector>

#include "foam_cases/openfoam.h"

namespace tw {

struct Scene;

/// All that are here, sound or not. $TWINWAKE_OPENFOAM_PREFIX leaves the one behind it alone. Else the one whose
/// environment is loaded (WM_PROJECT_DIR) first, then the mended solvers of twinwake's own folders
/// (foam_cases/own_openfoam.h), then the usual places (/usr/share/openfoam, /usr/lib/openfoam, /opt, ~/OpenFOAM) or, in
/// their stead, the folders of $TWINWAKE_OPENFOAM_PLACES (colons between). `preferred`, an installation's folder or
/// that of its solver, leaves only what belongs to it. All programs are of the release's own folder; one that lacks a
/// program is unusable, and its verdict names it. Each has been self-tested (0.2 s).
std::vector<OpenFoam> find_openfoam(const std::string& preferred = {});
/// The first sound one, of the loaded release if one is loaded and none is preferred; throws InputError that names the
/// faulty ones and says what to install or run.
OpenFoam sound_openfoam(const std::string& preferred = {});
/// The same, for what a scene asks for: with interIsoFoam as its solver where the surface is captured geometrically,
/// which stands beside the sound interFoam and has to be sound itself. Throws InputError where it is not.
OpenFoam openfoam_for(const Scene& scene);
/// A full pipe of water, turned about two axes, pushed from rest by 1000 Pa over 1 m for 0.1 s without friction: exact
/// answer 0.1 m/s along the pipe in every cell. Axis-aligned pipes hide the fault of miscompiled solvers. Sound below
/// 1e-4 m/s. Where a library of walls is beside the solver the pipe has such walls, and where one of zones, a zone
/// gives half of the push; a library that does not load or spoils the answer is left out.
void self_test(OpenFoam& candidate);

}  // namespace tw
