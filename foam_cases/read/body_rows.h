#pragma once
#include <filesystem>
#include <vector>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"
#include "record/run_record.h"

namespace tw {

/// Where a body is and how it moves.
struct BodyPlace {
    double time = 0;                                                           ///< [s]
    Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();  ///< of mass [m], [m/s], [rad/s]
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< turns it from how it stood at the start
};
/// Of a free body, every step, from the function object bodyState below `post` (postProcessing), starts joined.
std::vector<BodyPlace> free_places(const CasePlan& plan, const std::filesystem::path& post);

/// Of any body that the mesh follows, from where each kind is known: a prescribed one at the `times` [s], of several the
/// log's.
std::vector<BodyPlace> body_places(const CasePlan& plan, const BodyInMesh& which, const std::filesystem::path& post,
                                   const SolverLog& log, const std::vector<double>& times);

/// The same of a hull that is free (record/hull_motion.h).
void read_free_hull(const CasePlan& plan, const std::filesystem::path& post, RunRecord& record);
/// Its surface as it stood at the time, or at the last row before it [m].
Surface free_hull_at(const CasePlan& plan, const std::filesystem::path& post, double time);

/// Makes the table of a body that moves anew from what the solver has left below `post` (postProcessing): the columns
/// that every method's record has (record/run_record.h), one row per step. The force is that of water and air together.
/// The first three rows of a run have none: an impulsive start gives a false one. Of several bodies the log says where
/// they were.
void read_body(const CasePlan& plan, const BodyInMesh& which, const std::filesystem::path& post, const SolverLog& log,
               RunRecord& record);

}  // namespace tw
