// Standing gravity wave of small amplitude in a tank of ideal water: its frequency and its decay.
//
// Linear theory (Lamb, Hydrodynamics, 6th ed. 1932, art. 228), still water at z = 0, depth H, length L, k = n pi / L:
//
//   phi = A cosh k(z + H) / cosh kH cos kx cos(omega t),   omega^2 = g k tanh kH     (standing_wave_frequencies.csv)
//
// The engine's water has the sound speed c0, which slows the wave a little. Still water is then denser below,
// rho'/rho = -g/c0^2, and  div(rho grad phi) = rho phi_tt / c0^2  gives
//
//   phi'' - (g/c0^2) phi' - (k^2 - omega^2/c0^2) phi = 0,   phi' = 0 at -H,   g phi' = omega^2 phi at 0
//
// The particles start on a square lattice and the wave deforms it too little to break it. The kernel sum of a lattice,
// S = sum_j W_ij dp^2, changes under the area-preserving strain dx -> e^eps dx, dz -> e^-eps dz by S'' eps^2 / 2, and
// what the pressure p resists is the change of S: a stiffness that water does not have, of energy p S'' eps^2 / 2 per
// area. It bears the same ratio to gravity's at any spacing, so at a fixed h / dp the frequency does not converge to
// linear theory's, but by Rayleigh's principle to
//
//   omega'^2 / omega^2 = 1 + int int p S'' eps^2 / 2 dx dz / (rho g a^2 L / 4),   p = -rho g z,
//   eps = -a k cosh k(z + H) / sinh kH cos kx;   in deep water 1 + S''/4
//
// (derived here; S'' = 0.094 at h / dp = 1.5, 0.038 at 2, 0.018 at 2.5). At h / dp = 2 that is what is found. At 1.5
// the lattice is not stable (the like of S'' for shear is negative), gives way, and keeps about two thirds of its
// stiffness.
//
// Water has no viscosity here, the artificial one is nu = alpha h c0 / 8 in two dimensions (Monaghan 2005,
// doi:10.1088/0034-4885/68/8/R01) and damps the amplitude as exp(-2 nu k^2 t) (Lamb, art. 348). That goes to zero with
// the spacing, as h does.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "sph_solver/simulation.h"
#include "table_of.h"

namespace tw {
namespace standing_wave_test {

constexpr double g = 9.81, depth = 0.5, length = 1, k = std::numbers::pi / length;
constexpr double c0 = 22;           // ten times sqrt(g H)
constexpr double amplitude = 0.01;  // of the elevation [m]; k a = 0.03
constexpr double periods = 3;

double linear_frequency() {
    for (const Row& row : table_of("standing_wave_frequencies.csv"))
        if (row.at("case") == "generic" && number(row, "depth_m") == depth && number(row, "tank_length_m") == length &&
            number(row, "mode") == 1)
            return number(row, "omega_rad_per_s");
    throw std::runtime_error("no such wave in the table");
}

/// Frequency of the same wave in water of sound speed c0, by bisection.
double compressible_frequency() {
    const auto surface_condition = [](double omega) {
        const double a = g / (2 * c0 * c0), b = std::sqrt(a * a + k * k - omega * omega / (c0 * c0));
        const double lower = a - b, upper = a + b;  // phi = upper exp(lower (z + H)) - lower exp(upper (z + H))
        const double slope = lower * upper * (std::exp(lower * depth) - std::exp(upper * depth));
        const double value = upper * std::exp(lower * depth) - lower * std::exp(upper * depth);
        return g * slope / value - omega * omega;
    };
    double low = 0.5 * linear_frequency(), high = 1.5 * linear_frequency();
    for (int n = 0; n < 60; ++n) {
        const double middle = (low + high) / 2;
        (surface_condition(middle) > 0 ? low : high) = middle;
    }
    return low;
}

/// Frequency with the lattice's stiffness over that without.
double lattice_factor(double h_over_dp) {
    const Kernel kernel(h_over_dp, 2);
    const auto kernel_sum = [&](double strain) {
        double sum = 0;
        for (int i = -9; i <= 9; ++i)
            for (int j = -9; j <= 9; ++j) sum += kernel.W(std::hypot(i * std::exp(strain), j * std::exp(-strain)));
        return sum;
    };
    const double e = 0.02, second = (kernel_sum(e) + kernel_sum(-e) - 2 * kernel_sum(0)) / (e * e);
    double energy = 0;  // over rho g a^2 L / 4
    const int n = 1000;
    for (int i = 0; i < n; ++i) {
        const double z = -depth * (i + 0.5) / n, eps = k * std::cosh(k * (z + depth)) / std::sinh(k * depth);
        energy += second * -z * eps * eps * depth / n;  // the mean of cos^2 is 1/2
    }
    return std::sqrt(1 + energy);
}

/// grad phi / A of the first mode.
Vec3 mode(double x, double z) {
    const double c = std::cosh(k * depth);
    return k *
           Vec3(-std::sin(k * x) * std::cosh(k * (z + depth)) / c, 0, std::cos(k * x) * std::sinh(k * (z + depth)) / c);
}

struct Wave {
    double dp = 0, frequency = 0, decay = 0;  ///< [m], [rad/s], [1/s] of the amplitude
    double artificial = 0;                    ///< 2 nu k^2 [1/s]
    double kinetic_left = 0;                  ///< largest kinetic energy of the last half period over the start's [-]
};

Wave wave_of(double dp, double h_over_dp) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.h_over_dp = h_over_dp;
    s.state_equation.c0 = c0;
    s.domain = {Vec3(0, -1, -depth), Vec3(length, 1, depth)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(length, 1, 0)}}));
    const FieldsToSet p = simulation.fields_to_set();
    const double omega = linear_frequency(), potential = amplitude * g / omega;  // A of phi
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 u = potential * mode(p.x[i], p.z[i]);
        p.u[i] = static_cast<float>(u.x()), p.w[i] = static_cast<float>(u.z());
    }
    // the share of the mode in the motion, sum u . grad phi / sum |grad phi|^2: it swings and decays as phi does
    const auto share_and_energy = [&] {
        double product = 0, square = 0, energy = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3 m = mode(p.x[i], p.z[i]), u(p.u[i], 0, p.w[i]);
            product += u.dot(m), square += m.squaredNorm(), energy += u.squaredNorm();
        }
        return std::pair{product / square, energy};
    };
    const double start_energy = share_and_energy().second;
    std::vector<double> crossings, peak_times, peaks;
    double before = potential, before_time = 0, peak = 0, peak_time = 0, energy_peak = 0, last_energy_peak = 0;
    while (simulation.time() < (periods + 0.3) * 2 * std::numbers::pi / omega) {
        simulation.step();
        const auto [now, energy] = share_and_energy();
        if (before * now < 0) {
            crossings.push_back(before_time + (simulation.time() - before_time) * before / (before - now));
            if (crossings.size() > 1) peak_times.push_back(peak_time), peaks.push_back(peak);
            last_energy_peak = energy_peak;
            peak = energy_peak = 0;
        }
        if (std::abs(now) > peak) peak = std::abs(now), peak_time = simulation.time();
        energy_peak = std::max(energy_peak, energy);
        before = now, before_time = simulation.time();
    }
    Wave w{dp, std::numbers::pi * double(crossings.size() - 1) / (crossings.back() - crossings.front())};
    double n = 0, t = 0, y = 0, tt = 0, ty = 0;  // line through the logarithms of the peaks
    for (std::size_t m = 0; m < peaks.size(); ++m) {
        const double log_peak = std::log(peaks[m]);
        n += 1, t += peak_times[m], y += log_peak, tt += peak_times[m] * peak_times[m], ty += peak_times[m] * log_peak;
    }
    w.decay = -(n * ty - t * y) / (n * tt - t * t);
    w.artificial = 2 * s.alpha * simulation.h() * c0 / 8 * k * k;
    w.kinetic_left = last_energy_peak / start_energy;
    return w;
}

/// Prints the table of three resolutions.
std::vector<Wave> waves_of(double h_over_dp) {
    const double linear = linear_frequency(), compressible = compressible_frequency(),
                 limit = lattice_factor(h_over_dp) * compressible;
    std::printf(
        "standing wave, h/dp = %g: linear theory %.4f rad/s; c0 = %g m/s makes %+.2f %%; the lattice %+.2f %%\n",
        h_over_dp, linear, c0, 100 * (compressible / linear - 1), 100 * (limit / compressible - 1));
    std::printf("  H/dp | omega   to linear  to both  order | decay 1/s  2 nu k^2  order | E_kin left  seconds\n");
    std::vector<Wave> waves;
    for (const double dp : {0.05, 0.025, 0.0125}) {
        const auto start = std::chrono::steady_clock::now();
        const Wave w = wave_of(dp, h_over_dp);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        double order = NAN, decay_order = NAN;
        if (!waves.empty()) {
            order = std::log2(std::abs((waves.back().frequency - limit) / (w.frequency - limit)));
            decay_order = std::log2(waves.back().decay / w.decay);
        }
        std::printf("  %4.0f | %.4f   %+.2f %%  %+.2f %%  %5.2f | %.4f     %.4f    %5.2f | %.3f       %.1f\n",
                    depth / dp, w.frequency, 100 * (w.frequency / linear - 1), 100 * (w.frequency / limit - 1), order,
                    w.decay, w.artificial, decay_order, w.kinetic_left, taken.count());
        waves.push_back(w);
    }
    return waves;
}

TEST(StandingWave, SwingsNearTheFrequencyOfLinearTheoryAndDecaysLessWithFinerSpacing) {
    const double linear = linear_frequency(), limit = lattice_factor(1.5) * compressible_frequency();
    const std::vector<Wave> waves = waves_of(1.5);
    for (const Wave& w : waves) {
        EXPECT_LT(std::abs(w.frequency / linear - 1), 0.015) << w.dp;  // found 1.1 %
        EXPECT_LT(w.frequency, limit) << w.dp;                         // stiffer than its lattice it cannot be
        EXPECT_LT(w.decay, 2 * w.artificial) << w.dp;                  // found 1.5 times it
        EXPECT_GT(w.decay, 0.7 * w.artificial) << w.dp;
    }
    EXPECT_LT(waves[1].decay, 0.75 * waves[0].decay);
    EXPECT_LT(waves[2].decay, 0.80 * waves[1].decay);
}

TEST(StandingWave, WithAWiderKernelConvergesToTheFrequencyOfItsLattice) {
    const double limit = lattice_factor(2) * compressible_frequency();
    const std::vector<Wave> waves = waves_of(2);
    const auto error = [&](std::size_t n) { return std::abs(waves[n].frequency / limit - 1); };
    EXPECT_LT(error(2), 0.0015);                                 // found 0.03 %
    EXPECT_GT(std::log2(error(0) / error(2)) / 2, 1.5);          // order of convergence
    EXPECT_NEAR(waves[2].decay / waves[2].artificial, 1, 0.25);  // found +10 %
    EXPECT_LT(waves[1].decay, 0.6 * waves[0].decay);
    EXPECT_LT(waves[2].decay, 0.6 * waves[1].decay);
}

}  // namespace standing_wave_test
}  // namespace tw
