// Order in time of the schemes (SimulationSetup::scheme), on a standing wave of sound in a closed box of water without
// dissipation: u = U sin(pi x) cos(omega t). The box of particles is a linear system with an omega of its own, 1 %
// below pi c0 (see acoustic_pulse_test.cpp), which Runge-Kutta with a tenth of the step finds first; against that wave
// all error is that of the scheme.
//
//   symplectic Euler      1: its velocity is half a step ahead (the frequency is of second order all the same)
//   kick-drift-kick       2
//   predictor-corrector   2
//   Runge-Kutta           4
//
// And the energy that the integrator gives to the water, in a vortex cell: closed box, u = sin(pi x) cos(pi z), no
// dissipation. The pair sums of continuity and pressure are dual, so all change of energy is that of the scheme.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "base/numbers.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace time_schemes_test {

constexpr double c0 = 20;

/// Calls look(t, a) after every step, a the velocity's share in the mode over the start's.
template <class Look>
void swing(Scheme scheme, double cfl, double until, Look look) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 1.0 / 20;
    s.scheme = scheme;
    s.cfl = cfl;
    s.alpha = s.delta = s.shifting = 0;
    s.state_equation.c0 = c0;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(0, -1, 0), Vec3(1, 1, 0.5)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    Fluid water = fill_with_fluid(s, {s.domain});
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    const FieldsToSet p = simulation.fields_to_set();
    constexpr double U = 1e-3;
    for (std::size_t i = 0; i < p.size(); ++i) p.u[i] = static_cast<float>(U * std::sin(pi * p.x[i]));
    while (simulation.time() < until) {
        simulation.step();
        double a = 0;
        for (std::size_t i = 0; i < p.size(); ++i) a += double(p.u[i]) * std::sin(pi * p.x[i]);
        look(simulation.time(), a / (U * double(p.size()) / 2));
    }
}

/// Angular frequency from the first and last zero of ten periods.
double frequency() {
    double first = 0, last = 0, then = 0, before = 1;
    int zeros = 0;
    swing(Scheme::rk4_frozen_diffusion, 0.1, 10 * 2 / c0, [&](double t, double a) {
        if (a * before < 0) {
            last = then + (t - then) * before / (before - a);
            if (zeros++ == 0) first = last;
        }
        then = t, before = a;
    });
    return pi * (zeros - 1) / (last - first);
}

/// Largest difference from cos(omega t) in two periods, over the amplitude.
double error_of(Scheme scheme, double cfl, double omega) {
    double largest = 0;
    swing(scheme, cfl, 4 * pi / omega,
          [&](double t, double a) { largest = std::max(largest, std::abs(a - std::cos(omega * t))); });
    return largest;
}

TEST(TimeSchemes, ConvergeInTimeWithTheirOrder) {
    const double omega = frequency();
    EXPECT_NEAR(omega / (pi * c0), 1, 0.02);
    struct Case {
        const char* name;
        Scheme scheme;
        double order, finest;  ///< at C = 0.35
    };
    std::printf("standing sound, largest error of the velocity in two periods over its amplitude\n");
    std::printf("                       C = 1.4       0.7      0.35   order\n");
    for (const Case& c : {Case{"symplectic Euler", Scheme::symplectic_euler, 1, 0.06},
                          Case{"kick-drift-kick", Scheme::kick_drift_kick, 2, 0.006},
                          Case{"predictor-corrector", Scheme::predictor_corrector, 2, 0.02},
                          Case{"RK4, frozen diffusion", Scheme::rk4_frozen_diffusion, 4, 2e-5}}) {
        const double coarse = error_of(c.scheme, 1.4, omega), middle = error_of(c.scheme, 0.7, omega),
                     fine = error_of(c.scheme, 0.35, omega);
        const double order = std::log2(coarse / fine) / 2;
        std::printf("%-22s %8.2e  %8.2e  %8.2e   %5.2f\n", c.name, coarse, middle, fine, order);
        EXPECT_NEAR(order, c.order, 0.25) << c.name;
        EXPECT_LT(fine, c.finest) << c.name;
    }
}

/// Change of energy from the first to the last twentieth of 0.3 s, over the energy.
double energy_gained(Scheme scheme, double cfl) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 1.0 / 24;
    s.scheme = scheme;
    s.cfl = cfl;
    s.alpha = s.delta = s.shifting = 0;
    s.state_equation.c0 = 15;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(0, -1, 0), Vec3(1, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    Fluid water = fill_with_fluid(s, {s.domain});
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = static_cast<float>(std::sin(pi * p.x[i]) * std::cos(pi * p.z[i]));
        p.w[i] = static_cast<float>(-std::cos(pi * p.x[i]) * std::sin(pi * p.z[i]));
        // the pressure that turns it, rho U^2 (cos 2 pi x + cos 2 pi z) / 4, and 1 kPa more: no tension
        const double pressure = s.rho0 / 4 * (std::cos(2 * pi * p.x[i]) + std::cos(2 * pi * p.z[i])) + 1000;
        p.drho[i] = s.state_equation.deviation(s.rho0, pressure);
    }
    // With one evaluation a step the density is known half a step before the velocity: the kinetic energy of the step
    // before belongs to the mean of its elastic energy and this one's.
    const bool staggered = scheme == Scheme::symplectic_euler || scheme == Scheme::kick_drift_kick;
    double first = 0, last = 0, firsts = 0, lasts = 0, kinetic_before = 0, elastic_before = 0;
    const double end = 0.3;
    while (simulation.time() < end) {
        simulation.step();
        double kinetic = 0, elastic = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double r = double(p.drho[i]) / s.rho0;
            kinetic += (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]) / 2;
            elastic += 15 * 15 * (std::log1p(r) - r / (1 + r));
        }
        const double energy = staggered ? kinetic_before + (elastic_before + elastic) / 2 : kinetic + elastic;
        kinetic_before = kinetic, elastic_before = elastic;
        if (simulation.steps() > 1 && simulation.time() < 0.05 * end) first += energy, firsts += 1;
        if (simulation.time() > 0.95 * end) last += energy, lasts += 1;
    }
    return last / lasts / (first / firsts) - 1;
}

TEST(TimeSchemes, OfSecondOrderGiveTheWaterNoEnergy) {
    const double euler = energy_gained(Scheme::symplectic_euler, 0.7),
                 euler_half = energy_gained(Scheme::symplectic_euler, 0.35),
                 kick = energy_gained(Scheme::kick_drift_kick, 0.7),
                 runge_kutta = energy_gained(Scheme::rk4_frozen_diffusion, 1.4);
    std::printf(
        "vortex: energy gained %.2e (symplectic Euler, C = 0.7), %.2e (0.35), %.1e (kick-drift-kick, 0.7), "
        "%.1e (RK4, 1.4)\n",
        euler, euler_half, kick, runge_kutta);
    EXPECT_GT(euler, 1e-3);                   // or this test sees nothing
    EXPECT_NEAR(euler / euler_half, 2, 0.3);  // first order
    EXPECT_LT(std::abs(kick), 0.05 * euler);
    EXPECT_LT(std::abs(runge_kutta), 0.05 * euler);
}

}  // namespace time_schemes_test
}  // namespace tw
