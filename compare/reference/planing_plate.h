#pragma once
#include <vector>

#include "compare/compare.h"
#include "record/run_record.h"

namespace tw {

/// Lift and drag of a flat plate that planes (record/planing_plate.h) for a record of this flow: two dimensions, no
/// gravity, a stream, and a hull whose wet bottom is one flat face (see prismatic_hull.h). Empty for any other record.
std::vector<Reference> planing_plate_references(const RunRecord& record);

}  // namespace tw
