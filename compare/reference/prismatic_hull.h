#pragma once
#include <optional>

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

}  // namespace tw
