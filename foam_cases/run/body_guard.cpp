#include "foam_cases/run/body_guard.h"

#include <fmt/format.h>

#include <cmath>

#include "foam_cases/body_axes.h"

namespace tw {

namespace {

std::optional<std::string> trouble_of(const CasePlan& plan, const MovingBody& body, const SolverLog::Body& now,
                                      double time) {
    const double speed = now.velocity.norm();
    const Box& tank = plan.scene->domain.box;
    const double g = std::abs(plan.scene->water.gravity);
    const double fastest = 10 * (body.fastest(g) + std::sqrt(g * tank.size().z()));
    if (!(speed <= fastest))
        return fmt::format(
            "body {} moves at {:.4g} m/s at t = {:.4g} s, more than the {:.4g} m/s that this scene can explain: its "
            "motion "
            "has become unstable, most often because the water that moves with it is many times as heavy as the body",
            body.name, speed, time, fastest);
    const bool across = plan.scene->domain.dimensions == 2 || plan.scene->symmetry_factor() > 1;  // a plane of symmetry
    const Eigen::Matrix3d turned =
        now.name.empty() ? Eigen::Matrix3d(now.attitude * body_axes(body.motion).axes.transpose()) : now.attitude;
    double farthest = 0;
    for (const Vec3& p : body.surface.points) {
        const Vec3 at = now.centre + turned * (p - body.motion.mass.centre);
        farthest = std::max(farthest, (at - p).norm());
        for (int a = 0; a < 3; ++a) {
            if (across && a == 1) continue;
            if (at[a] < tank.min[a] || (at[a] > tank.max[a] && a != 2))
                return fmt::format(
                    "body {} touches a wall or the floor of the tank at t = {:.4g} s, at ({:.4g}, {:.4g}, "
                    "{:.4g}) m; contact is not solved: shorten the run or enlarge the tank",
                    body.name, time, at.x(), at.y(), at.z());
        }
    }
    if (plan.mesh_motion.kind == MeshMotion::Kind::morphing && farthest > plan.mesh_motion.stretch())
        return fmt::format(
            "body {} has come {:.4g} m from where it started at t = {:.4g} s; the mesh round it folds soon after "
            "{:.4g} "
            "m; {}",
            body.name, farthest, time, plan.mesh_motion.stretch(),
            plan.several_bodies() ? "set the bodies farther apart and the walls farther off"
                                  : "enlarge the tank, or let the whole mesh move: [fvm] body_mesh = \"whole\"");
    return std::nullopt;
}

}  // namespace

std::optional<std::string> body_trouble(const CasePlan& plan, const SolverLog& log) {
    if (log.steps().empty()) return std::nullopt;
    for (const BodyInMesh& b : plan.bodies)
        for (const SolverLog::Body& now : log.bodies())
            if (now.name == (plan.several_bodies() ? b.patch : ""))
                if (const auto wrong = trouble_of(plan, b.body, now, log.steps().back().time)) return wrong;
    return std::nullopt;
}

}  // namespace tw
