#pragma once
#include <optional>
#include <string>

#include "record/run_record.h"
#include "scene/scene.h"
#include "statistics/settled_loads.h"

namespace tw {

/// Whether the loads of a run have settled at the frame that its record ends in, so that it may end there; never where
/// the scene is run to its duration. In numbers of the record alone: a resumed run ends at the same frame.
bool may_end(const Scene& scene, const RunRecord& record);

/// Says in the record how a run ended, and returns it as a sentence (the record's reason): settled at the time
/// `settled` [s], which then is its duration, or at its bound without. Nothing where the scene is run to its duration.
std::string note_end(const Scene& scene, RunRecord& record, std::optional<double> settled);

/// Removes that mark from a record that is resumed.
void forget_end(RunRecord& record);

/// Whether a run of this record (same run hash) has nothing left to do in this scene: it is finished, and as long as
/// the scene's duration, or ended because its loads had settled where the scene asks for no more.
bool is_complete(const Scene& scene, const RunRecord& record);

}  // namespace tw
