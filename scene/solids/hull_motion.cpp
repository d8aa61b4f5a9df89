#include "scene/solids/hull_motion.h"

#include <cmath>

#include "base/numbers.h"

namespace tw {
namespace {

/// Heave and pitch alone: the turn about y, bow up [rad].
double turn_of(const RigidBody::State& state) { return 2 * std::atan2(state.attitude.y(), state.attitude.w()); }

/// [deg]; what two turns that cancel leave is 0.
double trim_of(const Hull& hull, double turn) {
    const double trim = (hull.trim + turn) / degree;
    return std::abs(trim) < 1e-9 ? 0 : trim;
}

/// Depth of the transom's keel when the centre stands at height z and the hull is turned [m].
double transom_draft(const FreeHull& free, double z, double turn) {
    const Vec3 arm = free.transom_keel - free.motion.mass.centre;
    return -(z + std::cos(turn) * arm.z() - std::sin(turn) * arm.x());
}

}  // namespace

void append_hull_motion(Table& table, double time, const Hull& hull, const RigidBody::State& state, const Vec3& spin) {
    const double z = state.centre.z(), turn = turn_of(state);
    const std::size_t row = table.append(time);
    const auto put = [&](const char* name, const char* unit, double value) { table.set(row, name, unit, value + 0.0); };
    put("z", "m", z);
    put("vz", "m/s", state.velocity.z());
    put("trim", "deg", trim_of(hull, turn));
    put("trim_rate", "deg/s", spin.y() / degree);
    put("transom_draft", "m", transom_draft(hull.free.value(), z, turn));
}

std::optional<RestingHull> resting_hull(const Hull& hull) {
    if (!hull.free || !hull.free->at_rest) return {};
    const auto& [rise, turn] = *hull.free->at_rest;
    const double z = hull.free->motion.mass.centre.z() + rise;
    return RestingHull{z, trim_of(hull, turn), transom_draft(*hull.free, z, turn)};
}

}  // namespace tw
