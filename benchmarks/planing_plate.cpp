// A flat plate planing in a weightless channel against its exact force: the case on which the force on a planing hull
// can be judged, in half a minute. Two dimensions, depth H = 1, stream U = 1, rho0 = 1000.
//
//   planing_plate ANGLE_DEG Z_TE N_EXACT [H_OVER_DP [H_OVER_DP_KERNEL [SHIFTING [DURATION]]]]
//   planing_plate 30 -0.101338 0.987235            thick jet (0.2645 H)
//   planing_plate 10 -0.007811 0.898627            thin jet (0.0786 H)
//
// The trailing edge is at z = Z_TE, still water at 0. Momentum gives the force normal to the plate from the thickness
// delta of the jet that leaves forward along it, N = rho U^2 delta (1 + cos a) / sin a; delta for a given Z_TE comes
// from free-streamline theory (docs/decisions/024). N_EXACT is N over rho0 U^2 H. The force printed is the mean of the
// last 40 % of the run.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "meshes/generate.h"
#include "sph_solver/simulation.h"

using namespace tw;

int main(int argc, char** argv) {
    if (argc < 4) {
        std::puts("usage: planing_plate ANGLE_DEG Z_TE N_EXACT [H/dp [h/dp [shifting [duration]]]]");
        return 2;
    }
    const auto argument = [&](int k, double otherwise) { return argc > k ? std::atof(argv[k]) : otherwise; };
    const double angle = argument(1, 0) * std::numbers::pi / 180, z_te = argument(2, 0), exact = argument(3, 1);
    const double H_over_dp = argument(4, 25), duration = argument(7, 60);
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 1 / H_over_dp;
    s.h_over_dp = argument(5, s.h_over_dp);
    s.shifting = argument(6, s.shifting);
    s.state_equation.c0 = 10;
    s.gravity = Vec3::Zero();
    // The thin jet's stagnation point is 3.2 H before the edge, and what it does to the stream falls as exp(-pi x /
    // 2H): with the inlet at -6 H the stream is 1 % too strong there, and the force 1 to 4 % wrong.
    s.domain = {Vec3(-10, -1, -1), Vec3(4, 1, 2.6)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.stream = Stream{1, 0.5, std::ceil(2 * s.h_over_dp + 2) * s.dp};
    s.threads = 1;
    const double length = 5, thickness = 0.3, c = std::cos(angle), d = std::sin(angle);
    // a box whose lower right edge is turned to the trailing edge, bow up
    Surface plate = box_surface({Vec3(-length, -3, 0), Vec3(0, 3, thickness)});
    for (Vec3& p : plate.points) p = Vec3(p.x() * c + p.z() * d, p.y(), z_te - p.x() * d + p.z() * c);
    s.bodies = {plate};
    Box water = s.domain;
    water.max.z() = 0;
    water.min.x() -= s.stream->buffer;
    water.max.x() += s.stream->buffer;
    Fluid fluid = fill_with_fluid(s, {water});
    for (double& depth : fluid.depth) depth = 0;  // weightless
    Simulation simulation(s, fluid);

    double sum = 0;
    long steps = 0;
    while (simulation.time() < duration) {
        simulation.step();
        if (simulation.time() < 0.6 * duration) continue;
        const Vec3 force = simulation.load().force;
        sum += force.z() * c + force.x() * d;
        ++steps;
    }
    const double N = sum / static_cast<double>(steps) / s.rho0;
    std::printf("H/dp %g, h/dp %g, shifting %g, %g H/U: N = %.4f rho U^2 H, %+.2f %% of the exact %.4f\n", H_over_dp,
                s.h_over_dp, s.shifting, duration, N, 100 * (N / exact - 1), exact);
}
