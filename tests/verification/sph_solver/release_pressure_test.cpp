// The pressure with which a column of water begins that is let go at one side and on top: 0.15 m wide, 0.3 m high, in
// the corner of a tank. Exact (laplace p = 0; dp/dx = 0 at the wall x = 0, dp/dz = -rho g at the floor, p = 0 at the
// free side x = L and the top z = H):
//
//   p = rho g sum_n 2 (-1)^n / (L k_n^2) cos(k_n x) sinh(k_n (H - z)) / cosh(k_n H),   k_n = (n + 1/2) pi / L
#include "sph_solver/start_pressure.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "meshes/generate.h"
#include "sph_solver/bodies/samples.h"

namespace tw {
namespace release_pressure_test {

constexpr double L = 0.15, H = 0.3, g = 9.81;

/// p / (rho g).
double exact_head(double x, double z) {
    double sum = 0;
    for (int n = 0; n < 400; ++n) {
        const double k = (n + 0.5) * std::numbers::pi / L;
        // sinh(k (H - z)) / cosh(k H) without overflow
        const double fade = std::exp(-k * z) * (1 - std::exp(-2 * k * (H - z))) / (1 + std::exp(-2 * k * H));
        sum += 2 * (n % 2 == 0 ? 1 : -1) / (L * k * k) * std::cos(k * x) * fade;
    }
    return sum;
}

SimulationSetup tank(double dp, int dimensions = 2) {
    SimulationSetup s;
    s.dimensions = dimensions;
    s.dp = dp;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(0.6, dimensions == 2 ? dp : 0.06, 0.45)};
    s.mirrors.on = {{{true, true}, {dimensions == 3, dimensions == 3}, {true, false}}};
    return s;
}

double largest_error(const Fluid& fluid) {
    double worst = 0;
    for (std::size_t i = 0; i < fluid.places.size(); ++i)
        worst = std::max(worst, std::abs(fluid.depth[i] - exact_head(fluid.places[i].x(), fluid.places[i].z())));
    return worst / H;
}

TEST(ReleasePressure, OfAColumnIsThatOfIncompressibleWater) {
    std::printf("column let go: largest error of the pressure over rho g H\n");
    double before = 0;
    for (const int n : {10, 20, 40}) {
        SimulationSetup s = tank(L / n);
        const Box block{Vec3(0, 0, 0), Vec3(L, s.dp, H)};
        Fluid fluid = fill_with_fluid(s, {block});
        const double hydrostatic = largest_error(fluid);
        const int iterations = find_start_pressure(s, std::span(&block, 1), std::span(&fluid, 1));
        const double error = largest_error(fluid);
        std::printf("  L/dp %2d: %.2e (hydrostatic %.2f), %d iterations\n", n, error, hydrostatic, iterations);
        EXPECT_GT(hydrostatic, 0.5) << "the present start is far off";
        EXPECT_LT(error, 0.2 / n / n * 10);
        if (before > 0) { EXPECT_LT(error, 0.6 * before) << "it comes to the truth"; }
        before = error;
    }
}

TEST(ReleasePressure, InThreeDimensionsBetweenWallsIsTheSame) {
    SimulationSetup s = tank(L / 20, 3);
    const Box block{Vec3(0, 0, 0), Vec3(L, 0.06, H)};
    Fluid fluid = fill_with_fluid(s, {block});
    EXPECT_GT(find_start_pressure(s, std::span(&block, 1), std::span(&fluid, 1)), 0);
    EXPECT_LT(largest_error(fluid), 0.005);
}

// Behind a plate that reaches over it the water is held: hydrostatic, whatever stands beside it; and water whose free
// faces look up is left as it was, to the last bit.
TEST(ReleasePressure, IsHydrostaticWhereWaterIsHeld) {
    SimulationSetup s = tank(0.01);
    Surface plate = make_hull("box", {{"length", 0.03}, {"beam", 1.0}, {"height", 0.6}});
    const double to_the_water = L - plate.bounds().min.x();
    for (Vec3& p : plate.points) p.x() += to_the_water;
    s.bodies.emplace_back(plate);
    const std::vector<Box> blocks{Box{Vec3(0, 0, 0), Vec3(L, 0.01, H)}, Box{Vec3(0.3, 0, 0), Vec3(0.4, 0.01, 0.2)}};
    Fluid fluid = fill_with_fluid(s, blocks);
    const std::vector<double> before = fluid.depth;
    EXPECT_GT(find_start_pressure(s, blocks, std::span(&fluid, 1)), 0) << "the second block is let go";
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool held = fluid.places[i].x() < L;
        if (held) {
            EXPECT_NEAR(fluid.depth[i], before[i], 1e-4 * H);
        } else {
            EXPECT_LT(fluid.depth[i], before[i]);
        }
    }

    Fluid still = fill_with_fluid(s, {blocks[0]});
    const std::vector<double> held = still.depth;
    EXPECT_EQ(find_start_pressure(s, std::span(blocks).first(1), std::span(&still, 1)), 0);
    EXPECT_EQ(still.depth, held);
}

TEST(ReleasePressure, IsNotAskedForInStreamsNorWithoutWeight) {
    SimulationSetup s = tank(0.01);
    const Box block{Vec3(0, 0, 0), Vec3(L, 0.01, H)};
    const auto iterations = [&](const SimulationSetup& setup) {
        Fluid fluid = fill_with_fluid(tank(0.01), {block});
        return find_start_pressure(setup, std::span(&block, 1), std::span(&fluid, 1));
    };
    EXPECT_GT(iterations(s), 0);
    SimulationSetup stream = s;
    stream.stream.emplace();
    EXPECT_EQ(iterations(stream), 0);
    SimulationSetup weightless = s;
    weightless.gravity = Vec3::Zero();
    EXPECT_EQ(iterations(weightless), 0);
}

/// Pressure at the probe (0.05, 0) in the first 5 ms: mean, least and largest [Pa].
struct Begin {
    double mean = 0, least = 1e30, most = -1e30;
};
Begin begin_of(double dp, bool released) {
    const SimulationSetup s = tank(dp);
    const Box block{Vec3(0, 0, 0), Vec3(L, dp, H)};
    Fluid fluid = fill_with_fluid(s, {block});
    if (released) find_start_pressure(s, std::span(&block, 1), std::span(&fluid, 1));
    Simulation simulation(s, fluid);
    Begin b;
    double before = 0;
    while (before < 0.005) {
        simulation.step();
        PointSamples probe;
        probe.places = {Vec3(0.05, 0, 0)};
        simulation.sample(probe);
        b.mean += double(probe.p[0]) * (simulation.time() - before);
        b.least = std::min(b.least, double(probe.p[0])), b.most = std::max(b.most, double(probe.p[0]));
        before = simulation.time();
    }
    b.mean /= before;
    return b;
}

TEST(ReleasePressure, AColumnThatBeginsWithItDoesNotRing) {
    const double exact = 1000 * g * exact_head(0.05, 0);
    EXPECT_NEAR(exact, 1005, 1) << "Pa";
    std::printf("pressure at (0.05, 0) in the first 5 ms, exact %.0f Pa at the release\n", exact);
    for (const double dp : {0.01, 0.005}) {
        const Begin held = begin_of(dp, false), released = begin_of(dp, true);
        std::printf("  dp %.0f mm: hydrostatic start %.0f (%.0f to %.0f) Pa, this start %.0f (%.0f to %.0f) Pa\n",
                    1000 * dp, held.mean, held.least, held.most, released.mean, released.least, released.most);
        EXPECT_GT(held.most - held.least, 2 * exact) << "or there is nothing to mend";
        EXPECT_LT(released.most - released.least, 0.5 * exact);
        EXPECT_NEAR(released.mean, exact, 0.1 * exact);
    }
}

}  // namespace release_pressure_test
}  // namespace tw
