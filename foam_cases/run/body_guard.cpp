#include "foam_cases/run/body_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "foam_cases/body_axes.h"
#include "meshes/mass_properties.h"

namespace tw {

namespace {

/// The most kinetic energy that a free body can have when its centre of mass has risen by `rise` in water that was at rest
/// [J] (N m per metre of a section): what it had, and what weight and buoyancy can have given it on the way.
///
///   K <= K(0) + max(rho V - m, 0) g rise   or, below where it started,   K(0) + m g |rise|
///
/// The water takes energy and gives none. A tenth of the larger weight times the body's height is let pass; all of it
/// where the body turns, whose place alone does not say what buoyancy has done.
double most_energy(const CasePlan& plan, const MovingBody& body, double rise) {
    const RigidBodySetup& motion = body.motion;
    const Scene& scene = *plan.scene;
    const double g = std::abs(scene.water.gravity), mass = motion.mass.mass,
                 displaced = scene.water.density * mass_properties(body.surface).volume;
    const bool turns = motion.free.about[0] || motion.free.about[1] || motion.free.about[2];
    const double given = rise > 0 ? std::max(displaced - mass, 0.0) * rise : -mass * rise;
    return 0.5 * mass * (plan.release_factor * motion.velocity).squaredNorm() +
           g * (given + (turns ? 1 : 0.1) * std::max(displaced, mass) * body.surface.bounds().size().z());
}

/// Whether the water began at rest, with a level surface, and nothing moves it but bodies that are free.
bool water_began_at_rest(const CasePlan& plan) {
    return plan.half_space && !plan.stream && !plan.scene->tank_motion && plan.scene->water.gravity > 0 &&
           std::ranges::none_of(plan.bodies, [](const BodyInMesh& b) { return b.body.motion.law.has_value(); });
}

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
    const double energy = 0.5 * body.motion.mass.mass * speed * speed;
    if (water_began_at_rest(plan)) {
        const double most = most_energy(plan, body, now.centre.z() - body.motion.mass.centre.z());
        if (energy > most)
            return fmt::format(
                "body {} moves at {:.4g} m/s at t = {:.4g} s, with {:.3g} {} of energy, and what it had and what "
                "weight "
                "and buoyancy can have given it by now are {:.3g}: its motion has become unstable",
                body.name, speed, time, energy, plan.scene->spanwise_unit("J"), most);
    }
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
