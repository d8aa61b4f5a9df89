#pragma once
#include <cmath>

#include "sph_solver/simulation.h"

namespace tw {

/// A round drop of radius 1 m in two dimensions, no gravity: u = -A x + spin z, w = A z - spin x.
inline Simulation elliptic_drop(double dp, double A, double spin = 0, double shifting = SimulationSetup{}.shifting,
                                Scheme scheme = SimulationSetup{}.scheme) {
    SimulationSetup s;
    s.scheme = scheme;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = 1400;
    s.gravity = Vec3::Zero();
    s.shifting = shifting;
    s.domain = {Vec3(-4, -1, -4), Vec3(4, 1, 4)};
    Fluid drop;
    for (const Vec3& place : fill_with_fluid(s, {Box{Vec3(-1, 0, -1), Vec3(1, 0, 1)}}).places)
        if (std::hypot(place.x(), place.z()) < 1) drop.places.push_back(place), drop.depth.push_back(0);
    Simulation simulation(s, drop);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = static_cast<float>(-A * p.x[i] + spin * p.z[i]);
        p.w[i] = static_cast<float>(A * p.z[i] - spin * p.x[i]);
    }
    return simulation;
}

}  // namespace tw
