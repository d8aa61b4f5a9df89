#pragma once
#include <optional>
#include <vector>

#include "compare/compare.h"
#include "compare/reference/savitsky.h"
#include "record/run_record.h"

namespace tw {

/// The planing state of a record whose hull is prismatic where it is wet, read off the hull surface itself: in the
/// hull's own frame (trim taken out) 99 % of the area of the downward faces below still water must have the normal (0,
/// +-sin beta, -cos beta) of one deadrise angle beta of at most 40 degrees. Nothing when the hull has another shape, no
/// trim, or does not move through water. Of a hull that is free the trim is that of the last row of its motion, in which
/// its surface is recorded.
struct PrismaticHull {
    PlaningState state;
    double draft = 0;  ///< of the keel at the transom [m]
};
std::optional<PrismaticHull> prismatic_hull(const RunRecord& record);

/// Lift and drag of a flat plate that planes (record/planing_plate.h) for a record of this flow: two dimensions, no
/// gravity, a stream, and a hull whose wet bottom is one flat face (see prismatic_hull). Empty for any other record.
std::vector<Reference> planing_plate_references(const RunRecord& record);

}  // namespace tw
