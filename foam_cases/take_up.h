#pragma once
#include "record/run_record.h"

namespace tw {

/// Gives the new `record` of a resumed run all that the `earlier` record of the same run holds and the new
/// one does not make by itself: rows, frames, costs, the hull's pressure, and every attribute and number that was found
/// on the way (on what the forces are, the mesh's error at the hull, the speed of a release). Counts the restart.
void take_up(RunRecord earlier, RunRecord& record);

}  // namespace tw
