#pragma once
// A stream with a free surface past a box, three sizes of particles: for tests of what happens where sizes meet.
#include "base/numbers.h"
#include "meshes/generate.h"
#include "sph_solver/simulation.h"

namespace tw {

inline Zone zone_between(double x0, double x1, double z0, double z1) {
    return Zone({Box{Vec3(x0, -infinite, z0), Vec3(x1, infinite, z1)}});
}

inline SimulationSetup three_levels(int threads) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.02;
    s.state_equation.c0 = 20;
    s.domain = {Vec3(-2.4, -1, -1.6), Vec3(2.4, 1, 1.6)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.stream = Stream{1, 0.1, 6 * 0.08};
    s.zones = {zone_between(-1.2, 1.2, -0.96, infinite), zone_between(-0.48, 0.48, -0.4, infinite)};
    s.bodies.emplace_back(box_surface({Vec3(-0.1, -1, -0.1), Vec3(0.1, 1, 0.3)}));
    s.threads = threads;
    return s;
}

inline std::vector<Fluid> water_of_stream(const SimulationSetup& s) {
    return fill_levels(s, {Box{Vec3(-2.4 - s.stream->buffer, -1, -1.6), Vec3(2.4 + s.stream->buffer, 1, 0)}});
}

}  // namespace tw
