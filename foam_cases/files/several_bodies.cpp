#include "foam_cases/files/several_bodies.h"

#include "foam_cases/release.h"

// What was tried and measured: docs/decisions/032-rigid-bodies.md.

namespace tw {
namespace {

/// The degrees of freedom of a body as joints, one behind the other: along the earth's axes, then about z, y and x.
List joints_of(const DegreesOfFreedom& free) {
    List joints;
    const auto add = [&](const std::string& type) { joints.push_back(Dictionary{{"type", Word(type)}}); };
    for (std::size_t a = 0; a < 3; ++a)
        if (free.along[a]) add(std::string("P") + "xyz"[a]);
    for (const std::size_t a : {2u, 1u, 0u})
        if (free.about[a]) add(std::string("R") + "xyz"[a]);
    return joints;
}

/// Values of a vector along and of one about the earth's axes, in the order of the joints; at the start the axes of the
/// joints are the earth's.
void append_by_joint(List& values, const DegreesOfFreedom& free, const Vec3& along, const Vec3& about) {
    for (int a = 0; a < 3; ++a)
        if (free.along[static_cast<std::size_t>(a)]) values.push_back(along[a]);
    for (const int a : {2, 1, 0})
        if (free.about[static_cast<std::size_t>(a)]) values.push_back(about[a]);
}

Dictionary body_entry(const CasePlan& plan, const BodyInMesh& b) {
    const RigidBodySetup& motion = b.body.motion;
    const double share = plan.solved_share();
    const Eigen::Matrix3d inertia = share * motion.mass.inertia;
    return {{"type", Word("rigidBody")},
            {"parent", Word("root")},
            {"mass", share * motion.mass.mass},
            {"centreOfMass", Vec3(Vec3::Zero())},  // of the joint's frame, which stands there
            {"inertia", List{inertia(0, 0), inertia(0, 1), inertia(0, 2), inertia(1, 1), inertia(1, 2), inertia(2, 2)}},
            {"transform", Value::sequence({List{1, 0, 0, 0, 1, 0, 0, 0, 1}, motion.mass.centre})},
            {"joint", Dictionary{{"type", Word("composite")}, {"joints", joints_of(motion.free)}}},
            {"patches", List{Word(b.patch)}},
            {"innerDistance", plan.mesh_motion.inner},
            {"outerDistance", plan.mesh_motion.outer}};
}

}  // namespace

Dictionary newmark(const CasePlan& plan) { return {{"type", Word("Newmark")}, {"gamma", plan.newmark_gamma}}; }

Dictionary several_bodies(const CasePlan& plan) {
    Dictionary bodies;
    List places, velocities, accelerations;
    for (const BodyInMesh& b : plan.bodies) {
        const RigidBodySetup& motion = b.body.motion;
        bodies.add(b.patch, body_entry(plan, b));
        append_by_joint(places, motion.free, Vec3::Zero(), Vec3::Zero());
        append_by_joint(velocities, motion.free, motion.velocity, motion.spin);
        append_by_joint(accelerations, motion.free, Vec3(0, 0, first_rise(b.body, *plan.scene)), Vec3::Zero());
    }
    return plan.flavour.motion_solver("rigidBodyMotion", "rigidBodyMeshMotion",
                                      {{"report", true},
                                       {"solver", newmark(plan)},
                                       {"accelerationRelaxation", plan.relaxation},
                                       {"accelerationDamping", 1},  // anything else scales gravity too
                                       {"q", places},
                                       {"qDot", velocities},
                                       {"qDdot", accelerations},
                                       {"bodies", bodies}});
}

}  // namespace tw
