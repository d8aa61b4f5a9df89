#pragma once
#include "motion/rigid_body.h"
#include "record/run_record.h"

namespace tw {

/// The table of a hull that is free in a stream: what a towing tank measures, one row per step.
inline constexpr const char* hull_motion_table = "hull_motion";

/// Adds a row: height of the centre of gravity above still water, `z` [m], and its velocity upward `vz` [m/s]; `trim`,
/// bow up [deg], and its rate `trim_rate` [deg/s]; `transom_draft`, the depth of the transom's keel below still water
/// [m]. `time` is the state's.
void append_hull_motion(Table& table, double time, const Hull& hull, const RigidBody::State& state, const Vec3& spin);

/// How a hull floats at rest, in the same terms.
struct RestingHull {
    double z = 0, trim_deg = 0, transom_draft = 0;  ///< [m], [deg], [m]
};
/// Nothing for a hull that does not float.
std::optional<RestingHull> resting_hull(const Hull& hull);

}  // namespace tw
