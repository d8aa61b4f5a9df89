// Air as a second phase (air.h, pairs/level_pair.h) against formulas.
//
// A water column between two cushions of air in a closed tube (Bagnold 1939, J. Inst. Civ. Eng. 12, in its linear
// form). Sound of the same frequency in both phases, p = A sin(k_w z) in the water |z| < L/2 and B cos(k_a (z_wall -
// z)) in the air of height l; pressure and velocity are continuous at the interface:
//
//   rho_w / k_w tan(k_w L/2) = rho_a / k_a cot(k_a l),   k = omega / c;    omega^2 -> 2 rho_a c_a^2 / (rho_w L l)
//
// A standing wave at the interface of two layers of depth H in a tank of length L, k = pi/L (Lamb 1932, art. 231):
//
//   omega^2 = g k (rho_w - rho_a) tanh kH / (rho_w + rho_a)
//
// Layers at rest: p = -rho_w g z in the water below the interface z = 0.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "base/numbers.h"
#include "sph_solver/air.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace air_test {

/// Zero of a falling function between a and b.
double bisect(const std::function<double(double)>& f, double a, double b) {
    for (int n = 0; n < 60; ++n) (f((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
    return a;
}

/// Angular frequency from the times at which a record that starts at its crest crosses zero.
double frequency(const std::vector<double>& time, const std::vector<double>& value) {
    std::vector<double> zeros;
    for (std::size_t k = 1; k < time.size(); ++k)
        if ((value[k] > 0) != (value[k - 1] > 0))
            zeros.push_back(time[k - 1] + (time[k] - time[k - 1]) * value[k - 1] / (value[k - 1] - value[k]));
    EXPECT_GE(zeros.size(), 2u);
    return pi * double(zeros.size() - 1) / (zeros.back() - zeros.front());
}

SimulationSetup box(double dp, const Vec3& min, const Vec3& max) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.domain = {min, max};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    return s;
}

struct Cushions {
    static constexpr double L = 0.2, l = 0.1, c_w = 50, rho_w = 1000;
    AirOptions air;

    double exact() const {
        const auto balance = [&](double omega) {
            const double kw = omega / c_w, ka = omega / air.sound_speed;
            return air.density / ka / std::tan(ka * l) - rho_w / kw * std::tan(kw * L / 2);
        };
        return bisect(balance, 1, 0.99 * pi * std::min(c_w / L, air.sound_speed / (2 * l)));
    }
    /// Of the water's momentum.
    double found(double dp, Scheme scheme = Scheme::kick_drift_kick, double cfl = TimeOptions{}.cfl) const {
        SimulationSetup s = box(dp, Vec3(0, -1, -L / 2 - l), Vec3(12 * dp, 1, L / 2 + l));
        s.gravity = Vec3::Zero();
        s.state_equation.c0 = c_w;
        s.scheme = scheme, s.cfl = cfl;
        const std::vector<Box> water{{Vec3(0, -1, -L / 2), Vec3(12 * dp, 1, L / 2)}};
        Simulation simulation(s, fill_with_fluid(s, water));
        add_air(simulation, air, fill_with_air(s, water));
        EXPECT_EQ(simulation.gas()->fields().particles().size(), simulation.particles().size());
        for (float& w : simulation.fields_to_set().w) w = 0.05f;  // of the cushion's height: 0.4 %
        std::vector<double> time, momentum;
        while (simulation.time() < 2.5 * 2 * pi / exact()) {
            simulation.step();
            double sum = 0;
            for (const float w : simulation.particles().w) sum += double(w);
            time.push_back(simulation.time()), momentum.push_back(sum);
        }
        return frequency(time, momentum);
    }
};

TEST(Air, CushionsAreSpringsOfAWaterColumn) {
    const Cushions cushions;
    EXPECT_NEAR(cushions.exact(), std::sqrt(2 * 1.2 * 343 * 343 / (1000 * 0.2 * 0.1)), 0.03 * cushions.exact());
    for (const double cells : {10, 20}) {
        const double found = cushions.found(Cushions::l / cells);
        std::printf("cushions of %g spacings: %.3f rad/s, exact %.3f (%+.2f %%)\n", cells, found, cushions.exact(),
                    100 * (found / cushions.exact() - 1));
        EXPECT_NEAR(found, cushions.exact(), 0.01 * cushions.exact());
    }
}

struct Layers {
    static constexpr double H = 0.5, length = 1, g = 9.81, amplitude = 0.01, k = pi / length;
    double density, c0, c_air;

    double exact() const { return std::sqrt(g * k * (1000 - density) * std::tanh(k * H) / (1000 + density)); }
    Simulation simulation(double dp) const {
        SimulationSetup s = box(dp, Vec3(0, -1, -H), Vec3(length, 1, H));
        s.h_over_dp = 2;
        s.state_equation.c0 = c0;
        const std::vector<Box> water{{s.domain.min, Vec3(length, 1, 0)}};
        Simulation simulation(s, fill_with_fluid(s, water));
        AirOptions air;
        air.density = density, air.sound_speed = c_air;
        add_air(simulation, air, fill_with_air(s, water));
        return simulation;
    }
};

TEST(Air, WavesAtTheInterfaceOfTwoLayers) {
    for (const double density : {500.0, 1.2}) {
        const Layers layers{density, 22, density > 100 ? 22.0 : 100.0};
        const double omega = layers.exact(), dp = Layers::H / 20;
        Simulation simulation = layers.simulation(dp);
        // velocity of the linear wave: potential A cosh k(H -+ z) cos kx in each layer, opposite signs along x
        const auto start = [&](const FieldsToSet& p, double side) {
            for (std::size_t i = 0; i < p.size(); ++i) {
                const double a = Layers::amplitude * omega / std::sinh(Layers::k * Layers::H),
                             up = Layers::k * (Layers::H - side * p.z[i]);
                p.w[i] = static_cast<float>(a * std::sinh(up) * std::cos(Layers::k * p.x[i]));
                p.u[i] = static_cast<float>(side * a * std::cosh(up) * std::sin(Layers::k * p.x[i]));
            }
        };
        start(simulation.fields_to_set(), -1);
        start(simulation.gas()->fields_to_set(), 1);
        std::vector<double> time, share;
        while (simulation.time() < 1.75 * 2 * pi / omega) {
            simulation.step();
            double sum = 0;
            const Particles& p = simulation.particles();
            for (std::size_t i = 0; i < p.size(); ++i)
                sum += double(p.w[i]) * std::sinh(Layers::k * (Layers::H + p.z[i])) * std::cos(Layers::k * p.x[i]);
            time.push_back(simulation.time()), share.push_back(sum);
        }
        const double found = frequency(time, share);
        std::printf("layers of 1000 and %g kg/m3: %.4f rad/s, exact %.4f (%+.2f %%)\n", density, found, omega,
                    100 * (found / omega - 1));
        EXPECT_NEAR(found, omega, 0.03 * omega);
    }
}

TEST(Air, StaysAboveWaterAtRest) {
    const Layers layers{1.2, 22, 100};
    const double dp = Layers::H / 20;
    Simulation simulation = layers.simulation(dp);
    while (simulation.time() < 2) simulation.step();
    double kinetic = 0, pressure2 = 0, highest = -1, lowest = 1, air2 = 0;
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        kinetic += 0.5 * simulation.mass() * (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]);
        highest = std::max(highest, p.z[i]);
        const double exact = -1000 * 9.81 * p.z[i];
        pressure2 += std::pow(simulation.pressure(i) - exact, 2) / double(p.size());
    }
    const Level& air = *simulation.gas();
    for (std::size_t i = 0; i < air.fields().particles().size(); ++i) {
        lowest = std::min(lowest, air.fields().particles().z[i]);
        air2 += std::pow(double(air.fields().particles().u[i]), 2) + std::pow(double(air.fields().particles().w[i]), 2);
    }
    const double scale = 1000 * 9.81 * Layers::H;
    std::printf(
        "at rest: pressure %.2f %%, kinetic energy %.1e, highest water %.2f dp, lowest air %.2f dp, air %.3f m/s\n",
        100 * std::sqrt(pressure2) / scale, kinetic / (scale * Layers::H * Layers::length), highest / dp, lowest / dp,
        std::sqrt(air2 / double(air.fields().particles().size())));
    EXPECT_LT(std::sqrt(pressure2), 0.02 * scale);
    EXPECT_LT(kinetic, 1e-5 * scale * Layers::H * Layers::length);
    EXPECT_LT(highest, 0.5 * dp);
    EXPECT_GT(lowest, -0.5 * dp);
}

/// The midpoint rule is stable to a Courant number of 0.5 (docs/results/numerics.md).
TEST(Air, IsASpringInStepsOfSeveralStagesToo) {
    const Cushions cushions;
    for (const auto& [scheme, cfl] :
         {std::pair{Scheme::predictor_corrector, 0.35}, std::pair{Scheme::rk4_frozen_diffusion, 0.7}}) {
        const double found = cushions.found(Cushions::l / 10, scheme, cfl);
        std::printf("cushions, scheme %d: %.3f rad/s, exact %.3f (%+.2f %%)\n", static_cast<int>(scheme), found,
                    cushions.exact(), 100 * (found / cushions.exact() - 1));
        EXPECT_NEAR(found, cushions.exact(), 0.01 * cushions.exact());
    }
}

}  // namespace air_test
}  // namespace tw
