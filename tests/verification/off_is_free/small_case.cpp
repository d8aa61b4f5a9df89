// A dam of water over a block, thirty steps: what off_is_free_test.cpp counts the instructions of. Prints a sum over
// the state, so that both programs are seen to do the same.
#include <cstdio>

#include "meshes/generate.h"
#include "sph_solver/simulation.h"

using namespace tw;

int main() {
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.threads = 1;
    s.bodies = {box_surface({Vec3(0.6, 0.1, -0.1), Vec3(0.8, 0.2, 0.2)})};
    Simulation simulation(s, fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}}));
    for (int k = 0; k < 30; ++k) simulation.step();
    double sum = 0;
    for (std::size_t i = 0; i < simulation.particles().size(); ++i)
        sum += simulation.particles().x[i] * simulation.particles().u[i];
    std::printf("%zu particles, %.17g\n", simulation.particles().size(), sum);
}
