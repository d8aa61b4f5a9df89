// A weak pulse of sound that runs along a closed box of water (mirrors all round, no gravity).
//
// Linear acoustics: rho'(x, t) = f(x - c0 t), u = c0 rho' / rho0 keeps its shape and speed; at a rigid wall it turns
// round (Landau & Lifshitz, Fluid Mechanics, art. 64). The linear state equation has the same sound speed at every
// density, and rho'/rho0 = 1e-4 keeps steepening below 1e-4 of the speed. Numerical viscosity may only lower the pulse.
//
// Particles on a lattice carry long waves at m c0, m = sum_j F_ij x_ij^2 V_j: both sums over pairs, divergence and
// gradient, give m times a linear field's slope. m = 0.9974 for h / dp = 1.5 at any spacing; that is what the speed
// converges to, with the kernel's second order.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "sph_solver/simulation.h"

namespace tw {
namespace acoustic_pulse_test {

constexpr double c0 = 20, strength = 1e-4, width = 0.06;  // [m/s], rho'/rho0, standard deviation of the pulse [m]

struct Pulse {
    double dp = 0, speed = 0;            ///< over c0
    double highest = 0, left = 0;        ///< largest rho' away from the walls, and the last one, over the start's
    double most_energy = 0, energy = 0;  ///< largest and last acoustic energy over the start's
};

/// What the pair sums make of a linear field's slope on a square lattice.
double lattice_moment(double h_over_dp) {
    const Kernel kernel(h_over_dp, 2);
    double m = 0;
    for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j) m += kernel.F(std::hypot(i, j)) * i * i;
    return m;
}

/// From x = 0.3 over the wall at x = 1 back to x = 0.6; the box is 1 long and `12 dp` high.
Pulse pulse_of(double dp) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = c0;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(0, -1, 0), Vec3(1, 1, 12 * dp)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    Fluid water = fill_with_fluid(s, {s.domain});
    for (double& depth : water.depth) depth = 0;
    Simulation simulation(s, water);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double f = strength * std::exp(-0.5 * std::pow((p.x[i] - 0.3) / width, 2));
        p.drho[i] = static_cast<float>(s.rho0 * f), p.u[i] = static_cast<float>(c0 * f);
    }
    struct State {
        double centre = 0, crest = 0, energy = 0;
    };
    const auto state = [&] {
        State r;
        double weight = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double d = p.drho[i], kinetic = 0.5 * (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]);
            weight += d * d, r.centre += d * d * p.x[i], r.crest = std::max(r.crest, d);
            r.energy += simulation.mass() * (kinetic + 0.5 * std::pow(c0 * d / s.rho0, 2));
        }
        r.centre /= weight;
        return r;
    };
    const auto run_to = [&](double path, Pulse& r, const State& start) {
        while (c0 * simulation.time() < path) {
            simulation.step();
            const State now = state();
            // at the wall the crest is twice as high, and velocity and density, known half a step apart, do not add up
            const double gone = 0.3 + c0 * simulation.time();
            if (gone > 0.75 && gone < 1.25) continue;
            r.highest = std::max(r.highest, now.crest / start.crest);
            r.most_energy = std::max(r.most_energy, now.energy / start.energy);
        }
        return std::pair{state(), simulation.time()};
    };
    Pulse r;
    r.dp = dp;
    const State start = state();
    // two passages in free water of 0.4 and the wall between them: centre at 0.4, then, turned round, at 0.6
    const auto [there, t1] = run_to(0.1, r, start);
    const auto [back, t2] = run_to(1.1, r, start);
    r.speed = ((1 - there.centre) + (1 - back.centre)) / (t2 - t1) / c0;
    r.left = back.crest / start.crest;
    r.energy = back.energy / start.energy;
    return r;
}

TEST(AcousticPulse, TravelsAtTheSpeedOfSoundAndNeverGrows) {
    const double limit = lattice_moment(1.5);
    std::vector<Pulse> pulses;
    std::printf(
        "pulse of sound, standard deviation %g m, path 1 m with one wall; the lattice carries sound at %.4f c0\n",
        width, limit);
    std::printf(
        "  1/dp  speed/c0 - 1  to the lattice's  order | crest: highest  left | energy: highest  left | seconds\n");
    for (const double dp : {1.0 / 50, 1.0 / 100, 1.0 / 200}) {
        const auto start = std::chrono::steady_clock::now();
        const Pulse r = pulse_of(dp);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        const double order =
            pulses.empty() ? NAN : std::log2(std::abs((pulses.back().speed - limit) / (r.speed - limit)));
        std::printf("  %4.0f  %+.3f %%      %+.3f %%          %5.2f |        %.4f  %.3f |         %.5f  %.3f | %.1f\n",
                    1 / dp, 100 * (r.speed - 1), 100 * (r.speed / limit - 1), order, r.highest, r.left, r.most_energy,
                    r.energy, taken.count());
        pulses.push_back(r);
    }
    EXPECT_NEAR(pulses[2].speed, 1, 0.01);                                                 // found -0.6 %
    EXPECT_NEAR(pulses[2].speed / limit, 1, 0.006);                                        // found -0.35 %
    EXPECT_GT(std::log2((pulses[0].speed - limit) / (pulses[2].speed - limit)) / 2, 1.6);  // order of convergence
    for (const Pulse& r : pulses) {
        EXPECT_LT(r.highest, 1.005) << r.dp;
        // the start knows density and velocity at one moment, the steps half a step apart: second order in dt
        EXPECT_LT(r.most_energy, 1 + 0.03 * std::pow(50 * r.dp, 1.5)) << r.dp;
        EXPECT_LT(r.energy, 1) << r.dp;
    }
    EXPECT_GT(pulses[2].left, 0.97);
    EXPECT_GT(pulses[2].energy, 0.98);
}

}  // namespace acoustic_pulse_test
}  // namespace tw
