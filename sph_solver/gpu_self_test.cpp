#include "sph_solver/gpu_self_test.h"

#include <algorithm>
#include <cmath>

#include "meshes/generate.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/simulation.h"

namespace tw {

double gpu_self_test() {
    constexpr double depth = 0.6, gravity = 9.81;
    constexpr int steps = 40;
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.5, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.bodies = {box_surface({Vec3(0.6, -0.4, -0.3), Vec3(0.8, 0.9, 0.15)})};
    Simulation simulation(s, fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(1, 0.5, depth)}}), passes_beside_gpu());
    leave_steps_to_gpu(simulation);
    for (int k = 0; k < steps; ++k) simulation.step();
    PointSamples points;
    for (const double x : {0.03, 0.28, 0.52, 0.7, 0.9})
        for (const double z : {0.2, 0.3, 0.4}) points.places.emplace_back(x, 0.23, z);
    simulation.sample(points);
    double worst = 0;
    for (std::size_t k = 0; k < points.places.size(); ++k) {
        const double exact = s.rho0 * gravity * (depth - points.places[k].z());
        const double error = std::abs(double(points.p[k]) - exact) / (s.rho0 * gravity * depth);
        worst = error <= worst ? worst : error;  // one that is no number counts
    }
    return worst;
}

}  // namespace tw
