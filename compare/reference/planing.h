#pragma once
#include <optional>
#include <vector>

#include "compare/compare.h"
#include "compare/reference/savitsky.h"
#include "record/run_record.h"

namespace tw {

/// The planing state of a record whose hull is prismatic where it is wet, read off the hull surface itself: in the
/// hull's own frame (trim taken out) all but `largest_bow` of the area of the downward faces below still water must
/// have the normal (0, +-sin beta, -cos beta) of one deadrise angle beta of at most 40 degrees; the rest is a bow that
/// just dips in. Nothing when the hull has another shape, no trim, or does not move through water. Of a hull that is
/// free the trim is that of the last row of its motion, in which its surface is recorded.
struct PrismaticHull {
    PlaningState state;
    double draft = 0;  ///< of the keel at the transom [m]
    double bow = 0;    ///< share of the bottom below still water that is no part of the prism [-]
};
/// A part of the formula's own 10 %, even if what it adds or takes were all of its lift [-].
inline constexpr double largest_bow = 0.05;
std::optional<PrismaticHull> prismatic_hull(const RunRecord& record);

/// Lift and drag of a flat plate that planes (record/planing_plate.h) for a record of this flow: two dimensions, no
/// gravity, a stream, and a hull whose wet bottom is one flat face (see prismatic_hull). Empty for any other record.
std::vector<Reference> planing_plate_references(const RunRecord& record);

}  // namespace tw
