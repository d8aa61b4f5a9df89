#include "foam_cases/release.h"

#include <algorithm>
#include <cmath>

#include "base/gap.h"
#include "scene/mesh/step_limits.h"
#include "scene/solids/added_mass.h"

// Measured: docs/decisions/032-rigid-bodies.md.

namespace tw {

double first_rise(const MovingBody& body, const Scene& scene) {
    const double g = scene.water.gravity;
    if (scene.hull || !scene.water_blocks.empty()) return -g;
    const double wet = hydrostatics(body.surface).volume, share = wet / mass_properties(body.surface).volume,
                 mass = body.motion.mass.mass;
    return g * (scene.water.density * wet - mass) / (mass + share * added_mass(body, scene));
}

void plan_release(CasePlan& plan) {
    // A wall that moves gives the water its mean speed over a step, which is its speed half a step ago: the water lacks
    // the momentum of half a step, and the body has it. With steps that grow by a fifth that is a twelfth of all that it
    // gave since the release; with steps of a fiftieth of the time since then, a hundredth. No step is longer than
    // that, and none need be shorter than a fiftieth of the time in which a body falls through a cell.
    const double g = plan.scene->water.gravity;
    if (plan.bodies.empty() || plan.stream || !(g > 0)) return;
    const double crossing = std::sqrt(2 * plan.finest_cell / g);
    for (const BodyInMesh& b : plan.bodies) {
        const RigidBodySetup& motion = b.body.motion;
        const double speed = motion.velocity.norm() + motion.spin.norm() * b.body.surface.bounds().size().norm();
        if (motion.law || speed * crossing > plan.finest_cell) return;
    }
    for (double step = release_step(plan.finest_cell, g), begin = 0;
         step < plan.largest_step && begin < plan.scene->run.duration; begin = plan.step_caps.back().until, step *= 2)
        plan.step_caps.push_back({2 * steps_of_release * step, step});
    if (!plan.step_caps.empty()) plan.first_step = plan.step_caps.front().step;
}

bool released_in_air(const CasePlan& plan) {
    if (plan.bodies.size() != 1 || plan.scene->hull_is_free() || plan.moving().motion.law) return false;
    if (!(plan.moving().motion.velocity.norm() > 0) || !plan.step_caps.empty()) return false;
    const Box body = plan.moving().surface.bounds();
    double nearest = plan.half_space ? body.min.z() : HUGE_VAL;
    if (!plan.half_space)
        for (const Box& block : plan.scene->water_blocks) nearest = std::min(nearest, gap_of_boxes(body, block));
    return nearest > plan.finest_cell;
}

}  // namespace tw
