// What only shows with time: water that has to stay still, a time step at and beyond the stated limit, vortices that
// leave, a sheet that tears.
#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "meshes/generate.h"
#include "watched_run.h"

namespace tw {
namespace long_runs_test {

/// Root mean square of p + rho g z over rho g H.
double pressure_error(const Simulation& simulation, double depth) {
    const Particles& p = simulation.particles();
    double squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i) squares += std::pow(simulation.pressure(i) + 9810 * p.z[i], 2);
    return std::sqrt(squares / double(p.size())) / (9810 * depth);
}

TEST(LongStillTank, StaysStill) {
    // Ten times as long as deep, for 80 sqrt(H / g). The rows of the start give way at about 25 sqrt(H / g): a burst of
    // 1e-5 rho g H V that has mostly gone at 80.
    const double depth = 0.1;
    SimulationSetup s = plane(depth / 12, 10 * std::sqrt(2 * 9.81 * depth), 1);
    s.gravity = Vec3(0, 0, -9.81);
    s.domain = {Vec3(-5 * depth, -1, -depth), Vec3(5 * depth, 1, depth)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(5 * depth, 1, 0)}}));
    const std::size_t n = simulation.particles().size();
    run_on(simulation, 80 * std::sqrt(depth / 9.81), 0.01, 0.01);
    ASSERT_EQ(simulation.particles().size(), n);
    double top = -1;
    for (const double z : simulation.particles().z) top = std::max(top, z);
    const double motion = sums_of(simulation).energy / (simulation.mass() * double(n) * 9.81 * depth);
    std::cout << "kinetic energy over rho g H V " << motion << ", highest particle " << top / s.dp + 0.5
              << " dp off, pressure error " << pressure_error(simulation, depth) << "\n";
    EXPECT_LT(motion, 5e-6);
    EXPECT_NEAR(top, -s.dp / 2, 0.5 * s.dp);
    EXPECT_LT(pressure_error(simulation, depth), 0.012);
}

/// A cube of still water in a closed tank, in three dimensions.
double tank_error(double cfl) {
    SimulationSetup s;
    s.dp = 0.1;
    s.cfl = cfl;
    s.state_equation.c0 = 10 * std::sqrt(9.81);
    s.domain = {Vec3(-0.5, -0.5, -1), Vec3(0.5, 0.5, 0.5)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(0.5, 0.5, 0)}}));
    try {
        while (simulation.time() < 1) simulation.step();
    } catch (const RunError&) { return 1; }
    return pressure_error(simulation, 1);
}

TEST(TimeStep, IsStableUpToTheStatedCourantNumberOnly) {
    const double usual = tank_error(0.7), limit = tank_error(1.2), beyond = tank_error(1.5);
    std::cout << "pressure error with Courant numbers 0.7, 1.2, 1.5: " << usual << ", " << limit << ", " << beyond
              << "\n";
    EXPECT_LT(limit, 1.2 * usual);
    EXPECT_LT(limit, 0.02);
    EXPECT_GT(beyond, 5 * limit);
}

TEST(Outlet, LetsTheVorticesOfAnUprightPlateOut) {
    // Deep enough (rho g z at g = 2, 3 m and more) that no vortex core cavitates; slip walls above and below.
    SimulationSetup s = plane(0.08, 40, 1);
    s.gravity = Vec3(0, 0, -2);
    s.domain = {Vec3(-1.6, -1, -5.6), Vec3(3.2, 1, -3.2)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.stream = Stream{1, 0.3, 5 * s.dp};
    Surface plate = make_hull("box", {{"length", 0.32}, {"beam", 6}, {"height", 0.48}});
    const Box at = plate.bounds();
    for (Vec3& p : plate.points) p += Vec3(-(at.min.x() + at.max.x()) / 2, 0, -4.72 - at.min.z());
    s.bodies = {plate};
    Box water = s.domain;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer;
    Fluid fluid = fill_with_fluid(s, {water});
    for (std::size_t k = 0; k < fluid.depth.size(); ++k) fluid.depth[k] = -fluid.places[k].z();
    Simulation simulation(s, fluid);
    const Particles& p = simulation.particles();
    const double n = double(p.size());
    double across = 0, slowest = 1, fewest = n, most = n;
    while (simulation.time() < 14.4) {  // three times through
        run_on(simulation, simulation.time() + 0.1, 0.1, 0.03);
        if (HasFatalFailure()) return;
        fewest = std::min(fewest, double(p.size())), most = std::max(most, double(p.size()));
        for (std::size_t i = 0; i < p.size() && simulation.time() > 4.8; ++i)
            if (p.kind[i] == Kind::outlet && p.x[i] < s.domain.max.x() + s.dp)
                across = std::max(across, std::abs(double(p.w[i]))), slowest = std::min(slowest, double(p.u[i]));
    }
    const Ledger& l = simulation.ledger();
    const double entered = 2.4 * (14.4 - 0.15) / (s.dp * s.dp);  // U A t less the ramp, in particles
    std::cout << "through the outlet: across up to " << across << " U, along down to " << slowest << " U; particles "
              << fewest / n << " to " << most / n << " of the start; in " << double(l.in) / entered << " of U A t\n";
    EXPECT_GT(across, 0.2);  // vortices did leave
    EXPECT_LT(slowest, 0.8);
    EXPECT_EQ(static_cast<double>(l.in - l.out), double(p.size()) - n);
    EXPECT_NEAR(double(l.in) / entered, 1, 0.02);
    EXPECT_GT(fewest, 0.93 * n);  // found 0.958: the vortices' cores
    EXPECT_LT(most, 1.04 * n);
}

TEST(FreeJet, IsDrawnIntoDropsAndNothingIsLost) {
    // A sheet four spacings thick whose ends fly apart: u = 3 x. In one second it is four times as long, one spacing
    // thick and torn; in two there are drops.
    SimulationSetup s = plane(0.02, 40, 8);
    Simulation simulation(s, weightless(s, {Vec3(-0.5, 0, -0.04), Vec3(0.5, 0, 0.04)}));
    const FieldsToSet p = simulation.fields_to_set();
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) p.u[i] = static_cast<float>(3 * p.x[i]);
    const Sums start = sums_of(simulation);
    double most = 0;
    while (simulation.time() < 2) {
        run_on(simulation, simulation.time() + 0.02, 0.06, 0.02);
        if (HasFatalFailure()) return;
        most = std::max(most, sums_of(simulation).energy + elastic_of(simulation));
    }
    ASSERT_EQ(p.size(), n);
    const Sums end = sums_of(simulation);
    double volume = 0, gap = 0;
    std::vector<double> places = simulation.particles().x;
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < n; ++i) volume += s.rho0 / (s.rho0 + double(p.drho[i])) / double(n);
    for (std::size_t i = 1; i < n; ++i) gap = std::max(gap, places[i] - places[i - 1]);
    std::cout << "widest gap " << gap / (2 * simulation.h()) << " kernel radii, volume " << volume << ", energy kept "
              << end.energy / start.energy << ", largest " << most / start.energy << "\n";
    EXPECT_GT(gap, 2 * simulation.h());  // it did tear
    EXPECT_NEAR(volume, 1, 0.001);
    EXPECT_LT(most, start.energy * (1 + 1e-6));
    EXPECT_LT(std::hypot(end.x, end.z), 1e-6 * simulation.mass() * double(n) * 1.5);
}

}  // namespace long_runs_test
}  // namespace tw
