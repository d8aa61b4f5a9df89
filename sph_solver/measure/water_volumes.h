#pragma once
#include "record/run_record.h"
#include "scene/scene.h"
#include "sph_solver/simulation.h"

namespace tw {

/// Adds a row of the present time to the record's table of volumes (record/water_in_box.h), where the scene has such
/// boxes: of the particles of every size that count, each a cube of its spacing.
void record_volumes(const Simulation& simulation, const Scene& scene, RunRecord& record);

}  // namespace tw
