#pragma once
#include <string>

#include "record/run_record.h"
#include "scene/run/run_options.h"
#include "scene/scene.h"

namespace tw {

/// The point moments are taken about: the middle of the posed hull's bounding box in x and y, at still water (z = 0)
/// [m].
Vec3 moment_reference(const Scene& scene);
/// Fills what follows from the scene alone: attributes, numbers, scene text, hull, effects, raster, hull findings. Throws
/// std::logic_error for a method of `methods` of whose elements it does not know where they are finer.
RunRecord new_record(const Scene& scene, const std::string& method);
/// Numbers predicted_seconds, predicted_core_seconds, predicted_elements, predicted_memory and the command, where the
/// options say them.
void note_prediction(RunRecord& record, const RunOptions& options);

}  // namespace tw
