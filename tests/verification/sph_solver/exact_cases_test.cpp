// Cases with an exact answer that fix the engine's choices at walls and at the free surface.
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate.h"
#include "prism.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace exact_cases_test {

/// A closed tank of still water with a submerged box on lattice planes.
TEST(StillWater, PressesOnASubmergedBoxWithItsWeight) {
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 10 * std::sqrt(9.81 * 1.0);
    s.domain = {Vec3(-0.6, -0.6, -1), Vec3(0.6, 0.6, 0.5)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    Surface box = make_hull("box", {{"length", 0.4}, {"beam", 0.4}, {"height", 0.4}});
    const Box at = box.bounds();
    for (Vec3& p : box.points) p += Vec3(0, 0, -0.7 - at.min.z()) - Vec3((at.min.x() + at.max.x()) / 2, 0, 0);
    s.bodies = {box};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(0.6, 0.6, 0)}}));
    double sum = 0, pressure_error = 0, top = -1;
    long n = 0;
    while (simulation.time() < 1.0) {
        simulation.step();
        if (simulation.time() < 0.5) continue;
        sum += simulation.load().force.z(), ++n;
    }
    double squares = 0;
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        squares += std::pow(simulation.pressure(i) + 9810 * p.z[i], 2);
        top = std::max(top, p.z[i]);
    }
    pressure_error = std::sqrt(squares / double(p.size())) / 9810;
    std::cout << "force / weight = " << sum / double(n) / (9810 * 0.064) << ", pressure error " << pressure_error
              << " of rho g H, highest particle " << top / s.dp << " dp\n";
    EXPECT_NEAR(sum / double(n), 9810 * 0.064, 0.01 * 9810 * 0.064);
    EXPECT_LT(pressure_error, 0.015);
    EXPECT_NEAR(top, -s.dp / 2, 0.5 * s.dp);
}

/// Water that slides along the bottom of a plate and leaves it at a sharp rear edge feels nothing: no gravity, no
/// friction, and nothing pulls it round the edge. What force there is, over the time that the block takes to pass,
/// relative to rho U^2 times the block's thickness.
TEST(SharpEdge, WaterLeavesItWithoutSuction) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.02;
    s.state_equation.c0 = 20;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(-2, -1, -1), Vec3(2, 1, 1)};
    s.bodies = {prism_along_y({{-1.5, 0}, {0, 0}, {0, 0.4}, {-1.5, 0.4}}, 3)};
    const double length = 0.8, thickness = 0.3;
    Fluid block = fill_with_fluid(s, {Box{Vec3(-1, 0, -thickness), Vec3(-1 + length, 0, 0)}});
    for (double& depth : block.depth) depth = 0;
    Simulation simulation(s, block);
    for (float& u : simulation.fields_to_set().u) u = 1;
    Vec3 impulse = Vec3::Zero();
    while (simulation.time() < 1.2) {
        const double before = simulation.time();
        simulation.step();
        impulse += simulation.load().force * (simulation.time() - before);
    }
    const Vec3 c = impulse / (s.rho0 * thickness * length);  // of the block's own momentum
    std::cout << "lift and drag of an edge that water leaves: " << c.z() << ", " << c.x() << " of the momentum\n";
    EXPECT_LT(std::abs(c.z()), 1e-6);  // an edge that pulls makes 9e-5 of it
    EXPECT_LT(std::abs(c.x()), 1e-6);
}

/// Drag and lift coefficients (on the thickness) of a slender ellipse, 2.4 x 0.6, in a stream between walls.
std::pair<double, double> ellipse_in_stream(double dp) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = 25;
    s.gravity = Vec3(0, 0, -1);  // deep enough that no suction turns the pressure negative
    s.domain = {Vec3(-3, -1, -6), Vec3(3.5, 1, -2)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.stream = Stream{1, 0.5, 0.6};
    std::vector<std::pair<double, double>> section;
    for (int k = 0; k < 120; ++k)
        section.emplace_back(1.2 * std::cos(k * 0.0523598776), 0.3 * std::sin(k * 0.0523598776) - 4);
    s.bodies = {prism_along_y(section, 3)};
    Box water = s.domain;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer;
    Fluid fluid = fill_with_fluid(s, {water});
    for (std::size_t k = 0; k < fluid.depth.size(); ++k) fluid.depth[k] = -fluid.places[k].z();
    Simulation simulation(s, fluid);
    double drag = 0, lift = 0;
    long n = 0;
    while (simulation.time() < 4) {
        simulation.step();
        if (simulation.time() < 2) continue;
        drag += simulation.load().force.x(), lift += simulation.load().force.z(), ++n;
    }
    const double reference = 0.5 * s.rho0 * 0.6 * double(n);  // 1/2 rho U^2 times the thickness
    std::cout << "dp " << dp << ": drag coefficient on the thickness " << drag / reference << ", lift "
              << lift / reference << "\n";
    return {drag / reference, lift / reference};
}

/// Steady ideal flow past a closed body has no drag (d'Alembert). What the engine shows instead is its numerical
/// viscosity and the wake it makes behind the blunt end: a finding, stated in docs/results/numerics.md. It
/// must shrink with the spacing.
TEST(UniformStream, DragOfAClosedBodyIsNumericalAndShrinksWithTheSpacing) {
    const auto [coarse, coarse_lift] = ellipse_in_stream(0.1);
    const auto [fine, fine_lift] = ellipse_in_stream(0.05);
    EXPECT_LT(std::abs(fine), 0.8 * std::abs(coarse));
    EXPECT_LT(std::abs(fine), 0.2);
    // Upwards: buoyancy alone, rho g A over the same reference. Rounding decides which wake the mean of two seconds
    // meets: 3.5 % low with one instruction set, 5.7 % with the other.
    EXPECT_NEAR(fine_lift / (1000 * 1 * 3.14159265 * 1.2 * 0.3 / 300), 1, 0.08);
}

}  // namespace exact_cases_test
}  // namespace tw
