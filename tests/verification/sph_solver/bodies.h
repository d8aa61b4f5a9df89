// Bodies that move in a tank of two dimensions, for tests.
#pragma once
#include "meshes/generate.h"
#include "meshes/section.h"
#include "sph_solver/bodies/rigid_in_water.h"
#include "sph_solver/simulation.h"

namespace tw {

/// A tank in the plane y = 0, water below z = 0, walls all round but above.
inline SimulationSetup tank(double dp, double half_width, double depth, double above, double c0) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = c0;
    s.domain = {Vec3(-half_width, -dp / 2, -depth), Vec3(half_width, dp / 2, above)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    s.threads = 1;
    return s;
}

/// A body whose section with the plane is that of `solid`, in the x-z plane. Masses are per metre of span.
inline BodySetup section_body(const Surface& solid, double density) {
    const Surface prism = section_prism(solid);
    BodySetup body(with_span(prism, endless_span(prism)));
    body.moving = RigidBodySetup{};
    body.moving->mass = solid_mass(prism, density);
    body.moving->free = {{true, false, true}, {false, true, false}};
    return body;
}

inline BodySetup box_body(double width, double height, double draft, double density) {
    const Surface box = make_hull("box", {{"length", width}, {"beam", 1}, {"height", height}});
    return section_body(posed(box, {.draft = draft}), density);
}

inline Fluid water(const SimulationSetup& s) {
    Box below = s.domain;
    below.max.z() = 0;
    return fill_with_fluid(s, {below});
}

inline Vec3 centre_of(const Simulation& s) { return rigid_of(s.body(0)).state().centre; }
inline double turned_by(const Simulation& s) {
    return Eigen::AngleAxisd(rigid_of(s.body(0)).state().attitude).angle();
}
/// Of the active particles of a level [m2/s2].
inline double mean_square_velocity(const Level& level) {
    const Particles& p = level.fields().particles();
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (is_active(p.kind[i])) sum += double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i], ++n;
    return sum / n;
}
inline void run_to(Simulation& s, double time) {
    while (s.time() < time) s.step();
}
inline double speed_up(const Simulation& s) { return rigid_of(s.body(0)).state().velocity.z(); }

inline BodySetup circle_body(double diameter, double draft, double density) {
    return section_body(posed(make_hull("cylinder", {{"diameter", diameter}, {"span", 1}}), {.draft = draft}), density);
}

}  // namespace tw
