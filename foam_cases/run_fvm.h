#pragma once
#include "record/run_record.h"
#include "scene/run/run_options.h"
#include "scene/scene.h"

namespace tw {

/// Below, further ranks cost more than they bring.
inline constexpr double cells_per_rank = 20000;

/// Writes the interFoam case of the scene into `options.folder/case`, meshes, runs and reads it back into
/// `options.folder/record.h5`. Throws InputError (no or faulty OpenFOAM, ...) before anything is run; RunError after.
RunRecord run_fvm(const Scene& scene, const RunOptions& options);

}  // namespace tw
