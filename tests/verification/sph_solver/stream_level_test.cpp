// The ends of a stream below the critical speed. Such a stream wants one condition at its downstream end, without which
// its level is nobody's: water that crosses the outlet keeps what velocity it has.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "sph_solver/effects/forcing_zones.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace stream_level_test {

constexpr double speed = 0.7, depth = 0.2, g = 9.81;  ///< Froude number 0.5

/// A channel 2 m long, beyond which zones lie or are missing.
constexpr double ahead = 0.3, behind = 0.5, length = 2 + ahead + behind;

/// Mean height of the water above the level at which it flows in, over each second [m]; at the start a fifth more water
/// stands over 1.2 m of the channel.
std::vector<double> levels(bool zones) {
    SimulationSetup s;
    s.dimensions = 2;
    s.threads = 1;
    s.dp = 0.025;
    s.state_equation.c0 = 10 * std::sqrt(2 * g * depth);
    s.domain = {Vec3(-1 - ahead, -s.dp / 2, -depth), Vec3(1 + behind, s.dp / 2, 0.1)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.stream = Stream{speed, 0, std::ceil(2 * s.h_over_dp + 2) * s.dp};
    if (zones) s.effects = {ZoneForcing{{{0, false, -1, -1 - ahead, g / speed}, {0, true, 1, 1 + behind, g / speed}}}};
    Box water = s.domain;
    water.max.z() = 0;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer;
    const Box hump{Vec3(-0.6, -s.dp / 2, 0), Vec3(0.6, s.dp / 2, 0.05)};
    Simulation run(s, fill_with_fluid(s, {water, hump}));
    std::vector<double> means;
    for (int second = 1; second <= 10; ++second) {
        double sum = 0;
        int steps = 0;
        for (; run.time() < second; ++steps) {
            run.step();
            const Particles& p = run.particles();
            for (std::size_t i = 0; i < p.size(); ++i) sum += p.x[i] > -1 && p.x[i] < 1;
        }
        means.push_back(sum * s.dp * s.dp / 2 / steps - depth);
    }
    return means;
}

// What is too much leaves with the stream: U h comes in, U (h + eta) goes out, so that eta falls as exp(-U t / length).
// Without zones the level does not know where to go: it passes the one at which it flows in, and falls on.
TEST(StreamLevel, ReturnsToThatOfTheInletWhereAZoneLiesAtTheOutlet) {
    const std::vector<double> with = levels(true), without = levels(false);
    for (std::size_t k = 0; k < with.size(); ++k)
        std::printf("%zu s: %.1f mm with zones, %.1f mm without\n", k + 1, 1000 * with[k], 1000 * without[k]);
    const double left = std::exp(-5 * speed / length);  // of the fourth second's in the ninth
    EXPECT_NEAR(with[8] / with[3], left, 0.15);
    EXPECT_LT(std::abs(with[9]), 0.02 * depth);
    EXPECT_GT(std::abs(without[8] / without[3] - left), 0.15);  // or this test sees nothing
}

// Deep water is denser at its floor than at its surface, g H/c0^2 = 2.5 % here, and particles of equal mass on a lattice
// of equal cells leave that out of their pair sums. The stream has to come in at the density at which such a lattice is at
// rest in those sums. With that of rho g z it runs against a rise of pressure behind the inlet, whose head is 2 g H^2/(3
// c0^2), 16 mm, more than the 5 mm of its own speed, and is slowed down.
TEST(StreamLevel, DeepWaterKeepsItsSpeed) {
    constexpr double deep = 1, slow = 0.32;
    SimulationSetup s;
    s.dimensions = 2;
    s.threads = 1;
    s.dp = 0.05;
    s.state_equation.c0 = 20;
    s.domain = {Vec3(-1, -s.dp / 2, -deep), Vec3(1, s.dp / 2, 0.3)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.stream = Stream{slow, 0, std::ceil(2 * s.h_over_dp + 2) * s.dp};
    Box water = s.domain;
    water.max.z() = 0;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer;
    Simulation run(s, fill_with_fluid(s, {water}));
    double sum = 0, of = 0;
    while (run.time() < 1.5) {
        run.step();
        if (run.time() < 0.5) continue;
        const Particles& p = run.particles();
        for (std::size_t i = 0; i < p.size(); ++i)
            if (p.x[i] > -1 && p.x[i] < 0 && p.z[i] < -0.2) sum += double(p.u[i]), ++of;
    }
    std::printf("mean speed behind the inlet over the stream's %.3f\n", sum / of / slow);
    EXPECT_NEAR(sum / of / slow, 1, 0.02);
}

}  // namespace stream_level_test
}  // namespace tw
