#include "record/body_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "record/hull_motion.h"

namespace tw {
namespace {

/// The pose in one row of a table; nothing where a column is missing.
std::optional<BodyPose> pose_in_row(const RunRecord& record, const Table& table, const BodyShape& body,
                                    std::size_t row) {
    const auto value = [&](const char* column) {
        const Column* c = table.find(column);
        return c ? c->values[row] : std::nan("");
    };
    BodyPose pose{body.centre, body.centre, Eigen::Quaterniond::Identity()};
    if (body.table == hull_motion_table) {  // heave, and pitch about y, bow up
        const auto trim = record.numbers.find("trim");
        if (trim == record.numbers.end()) return {};
        const double turn = value("trim") * std::numbers::pi / 180 - trim->second;
        pose.centre.z() = value("z");
        pose.turn = Eigen::AngleAxisd(turn, Vec3::UnitY());
    } else {
        pose.centre = {value("x"), value("y"), value("z")};
        pose.turn = Eigen::Quaterniond(value("q0"), value("qx"), value("qy"), value("qz"));
    }
    if (!pose.centre.allFinite() || !pose.turn.coeffs().allFinite() || !(pose.turn.norm() > 0)) return {};
    pose.turn.normalize();
    return pose;
}

}  // namespace

Surface BodyPose::operator()(Surface surface) const {
    for (Vec3& p : surface.points) p = (*this)(p);
    return surface;
}

std::optional<BodyPose> body_pose(const RunRecord& record, const BodyShape& body, double time) {
    const auto found = record.tables.find(body.table);
    if (found == record.tables.end() || found->second.time.empty()) return {};
    const Table& table = found->second;
    const auto after = static_cast<std::size_t>(std::ranges::lower_bound(table.time, time) - table.time.begin());
    if (after == table.time.size()) return pose_in_row(record, table, body, after - 1);
    const std::optional<BodyPose> next = pose_in_row(record, table, body, after);
    const std::optional<BodyPose> last = after > 0 ? pose_in_row(record, table, body, after - 1)
                                                   : BodyPose{body.centre, body.centre, Eigen::Quaterniond::Identity()};
    if (!next || !last) return {};
    const double from = after > 0 ? table.time[after - 1] : 0, span = table.time[after] - from;
    const double share = span > 0 ? std::clamp((time - from) / span, 0.0, 1.0) : 1;
    return BodyPose{body.centre, last->centre + share * (next->centre - last->centre),
                    last->turn.slerp(share, next->turn)};
}

}  // namespace tw
