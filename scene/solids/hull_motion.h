#pragma once
#include "motion/rigid_body.h"
#include "record/table.h"
#include "scene/scene.h"

namespace tw {

/// Adds a row to the table of a hull that is free in a stream (record/hull_motion.h). `time` is the state's.
void append_hull_motion(Table& table, double time, const Hull& hull, const RigidBody::State& state, const Vec3& spin);

/// How a hull floats at rest, in the same terms.
struct RestingHull {
    double z = 0, trim_deg = 0, transom_draft = 0;  ///< [m], [deg], [m]
};
/// Nothing for a hull that does not float.
std::optional<RestingHull> resting_hull(const Hull& hull);

}  // namespace tw
