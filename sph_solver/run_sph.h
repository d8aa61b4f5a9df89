#pragma once
#include "record/run_record.h"
#include "scene/run/run_options.h"
#include "scene/scene.h"

namespace tw {

/// Runs the scene with smoothed particles into `options.folder` (record.h5, checkpoint.h5, snapshots/). Returns the
/// record as written. Throws InputError before anything is written; RunError after state was saved.
RunRecord run_sph(const Scene& scene, const RunOptions& options);

}  // namespace tw
