#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "record/run_record.h"

namespace tw {

/// A rigid motion from where a body stood at the start: x -> centre + turn (x - centre at the start).
struct BodyPose {
    Vec3 start = Vec3::Zero(), centre = Vec3::Zero();  ///< of mass [m]
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();

    Vec3 operator()(const Vec3& x) const { return centre + turn * (x - start); }
    Surface operator()(Surface surface) const;
    /// Where a place of now was at the start.
    Vec3 back(const Vec3& x) const { return start + turn.conjugate() * (x - centre); }
};

/// Where the record's table has the body at a time [s]: places linear and attitudes along the shortest turn between two
/// rows, from t = 0, where it stood at the start; after the last row as there. Nothing where the table is missing or
/// does not know.
std::optional<BodyPose> body_pose(const RunRecord& record, const BodyShape& body, double time);

}  // namespace tw
