#include "foam_cases/viscous_steps.h"

#include <algorithm>
#include <cmath>

#include "scene/solids/added_mass.h"

// Measured: docs/decisions/076-what-stops-and-steers-interfoam.md.

namespace tw {

namespace {

constexpr double largest_viscous_number = 15;

/// Of a section that of its sides alone, whose ends are not in the water [m2].
double area_in_water(const Surface& surface, bool section) {
    double area = 0;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 part =
            (surface.corner(t, 1) - surface.corner(t, 0)).cross(surface.corner(t, 2) - surface.corner(t, 0)) / 2;
        if (!section || std::abs(part.y()) < 0.5 * part.norm()) area += part.norm();
    }
    return area;
}

}  // namespace

void plan_coupling(CasePlan& plan) {
    // Body and water answer each other once in each outer corrector. The water feels the share beta of a change of the
    // body's acceleration (Newmark's rule, beta = (gamma + 1/2)^2 / 4): with this relaxation the first answer is right
    // if the added mass is, and the answers converge as long as it is below twice that. With gamma = 1/2 what is left
    // swings from step to step and dies down by 2 m / M a step only; with 1 it is gone in three steps.
    double added = 0;
    for (const BodyInMesh& b : plan.bodies)
        added = std::max(
            added, (added_mass(b.body, *plan.scene) + viscous_added_mass(plan, b.body)) / b.body.motion.mass.mass);
    plan.newmark_gamma = added > 9 ? 1 : 0.5;
    const double beta = std::pow(plan.newmark_gamma + 0.5, 2) / 4;
    plan.relaxation = std::min(1 / (1 + beta * added), 0.9);
    plan.outer_correctors = plan.relaxation >= 0.7 ? 2 : 3;
    // Where the water's surface is moved once more with the velocities that answer it, both are implicit and a wave
    // loses pi omega dt of its height a period; where it goes first, nearly nothing (decision 032). A body that is not
    // light answers soon enough once a step.
    if (plan.scene->has_wave() && !plan.several_bodies() && plan.relaxation >= 0.6) plan.outer_correctors = 1;
}

void plan_viscous_steps(CasePlan& plan) {
    const double nu = plan.viscous ? plan.scene->water.kinematic_viscosity : 0, dx = plan.finest_cell;
    const double neighbours = 2 * plan.scene->domain.dimensions;
    plan.pressure_correctors = plan.outer_correctors > 1 ? 1 : plan.scene->fvm.correctors;
    const double D = neighbours * nu * plan.largest_step / (dx * dx),
                 left_out = std::pow(D / (1 + D), plan.outer_correctors * plan.pressure_correctors);
    if (!(left_out > 0.01)) return;
    plan.momentum_predictor = true;
    plan.pressure_correctors = std::max(plan.pressure_correctors, 2);
    plan.largest_step = std::min(plan.largest_step, largest_viscous_number * dx * dx / nu);
    if (!plan.mesh_moves()) return;
    if (!plan.moving().motion.law) plan_coupling(plan);
    plan.outer_correctors = 3;
}

double viscous_added_mass(const CasePlan& plan, const MovingBody& body) {
    if (!plan.momentum_predictor) return 0;
    const Water& water = plan.scene->water;
    return water.density * area_in_water(body.surface, plan.scene->domain.dimensions == 2) *
           std::sqrt(water.kinematic_viscosity * plan.largest_step);
}

}  // namespace tw
