// Water at rest for a long time: 40 s of a tank with a free surface, in two dimensions.
//
// Exact: nothing moves, p = -rho g z. What is asked of a long tank (Antuono et al. 2010,
// doi:10.1016/j.cpc.2009.11.002, show how diffusion without the gradient's correction loses the surface in that time):
// the surface within half a spacing, and a kinetic energy below 1e-6 of rho g H V.
//
// The engine meets both at 40 s. On the way, between 4 and 8 s, the lattice of the start gives way (at h / dp = 1.5 it
// is not stable, see standing_wave_test.cpp) and sets free up to 8e-6 for a second or two. With h / dp = 2 it does not.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "sph_solver/simulation.h"

namespace tw {
namespace still_tank_test {

struct Rest {
    double surface = 0;       ///< largest excursion of the highest particle in a column two spacings wide, over dp
    double kinetic = 0;       ///< over rho g H V: mean of the last 5 s
    double most_kinetic = 0;  ///< largest after the first second
    double pressure = 0;      ///< root mean square of p + rho g z over rho g H, at the end
};

Rest rest_of(double dp, double h_over_dp, double length, double until) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.h_over_dp = h_over_dp;
    s.state_equation.c0 = 10 * std::sqrt(9.81 * 1.0);
    s.domain = {Vec3(0, -1, -1), Vec3(length, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(length, 1, 0)}}));
    const Particles& p = simulation.particles();
    const auto n = static_cast<double>(p.size());
    const double scale = s.rho0 * 9.81 * 1 * (length * 1);  // rho g H V, V = length H per metre of width
    Rest r;
    double sum = 0, samples = 0;
    while (simulation.time() < until) {
        simulation.step();
        if (simulation.steps() % 20 != 0) continue;
        double kinetic = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
            kinetic += simulation.mass() / 2 * (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]) / scale;
        if (simulation.time() > 1) r.most_kinetic = std::max(r.most_kinetic, kinetic);
        if (simulation.time() > until - 5) sum += kinetic, ++samples;
        std::vector<double> highest(static_cast<std::size_t>(length / dp / 2), -1.0);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto column = static_cast<std::size_t>(std::max(0.0, p.x[i]) / (2 * dp));
            double& top = highest[std::min(column, highest.size() - 1)];
            top = std::max(top, p.z[i]);
        }
        for (const double top : highest) r.surface = std::max(r.surface, std::abs(top + dp / 2) / dp);
    }
    r.kinetic = sum / samples;
    for (std::size_t i = 0; i < p.size(); ++i)
        r.pressure += std::pow((simulation.pressure(i) + s.rho0 * 9.81 * p.z[i]) / (s.rho0 * 9.81), 2) / n;
    r.pressure = std::sqrt(r.pressure);
    return r;
}

TEST(StillTank, StaysAtRestForFortySeconds) {
    std::printf("still tank 1 x 1 m, 40 s; energies over rho g H V\n");
    std::printf("  H/dp  h/dp | surface  kinetic: last 5 s  largest after 1 s | pressure, rms of rho g H\n");
    for (const auto& [dp, h_over_dp] : {std::pair{0.1, 1.5}, std::pair{0.05, 1.5}, std::pair{0.1, 2.0}}) {
        const Rest r = rest_of(dp, h_over_dp, 1, 40);
        std::printf("  %4.0f  %4.1f | %.3f dp  %.1e           %.1e          | %.2f %%\n", 1 / dp, h_over_dp, r.surface,
                    r.kinetic, r.most_kinetic, 100 * r.pressure);
        EXPECT_LT(r.surface, 0.5) << dp;
        EXPECT_LT(r.kinetic, 1e-6) << dp;                              // found 3e-8
        EXPECT_LT(r.most_kinetic, h_over_dp < 2 ? 3e-5 : 1e-6) << dp;  // found 8e-6: more than is asked of the end
        EXPECT_LT(r.pressure, 0.02) << dp;                             // found 0.9 to 1.4 %
    }
}

/// Root mean square of p + rho g z over rho g H of all particles, the largest of the first second: a tank of 0.92 m
/// with 0.295 m of water, which no spacing here divides.
double largest_deviation(double dp) {
    constexpr double length = 0.92, depth = 0.295, g = 9.81;
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = 10 * std::sqrt(g * depth);
    s.domain = {Vec3(0, -1, -depth), Vec3(length, 1, 0.5)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(length, 1, 0)}}));
    const Particles& p = simulation.particles();
    EXPECT_NEAR(simulation.mass() * double(p.size()) / (s.rho0 * length * depth), 1, 1e-9);
    double most = 0;
    while (simulation.time() < 1) {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
            sum += std::pow((simulation.pressure(i) + s.rho0 * g * p.z[i]) / (s.rho0 * g * depth), 2);
        most = std::max(most, std::sqrt(sum / static_cast<double>(p.size())));
        simulation.step();
    }
    return most;
}

// Before water was made to fit, columns of particles stood a third of a spacing off the far wall, and the tank rang:
// the pressure at its wall swung from 51 to 8216 Pa where 2894 is right. What is left, 2.1 %, is the same in a tank
// that the spacing divides: water of c0 = 10 sqrt(g H) is 1 % denser at its floor and sinks until it is.
TEST(StillTank, OfAnyWidthAndDepthIsAsStillAsOneThatTheSpacingDivides) {
    for (const double dp : {0.015, 0.0212, 0.0106}) {
        const double rms = largest_deviation(dp);
        std::printf("still tank 0.92 x 0.295 m, dp = %g m: rms of the pressure's error %.2f %% of rho g H\n", dp,
                    100 * rms);
        EXPECT_LT(rms, 0.025) << dp;
    }
}

}  // namespace still_tank_test
}  // namespace tw
