#pragma once
// What the edge between two sizes of particles, or a forcing zone before a wall, throws back of a gravity wave that
// runs under a free surface. Two dimensions, water of depth H = lambda / 2, still surface at z = 0, the edge at x = 0
// through the whole depth, or the zone from there to the wall.
//
// A packet of progressive waves of linear theory (Lamb, Hydrodynamics, 6th ed. 1932, art. 228-229, 236), with C = cosh
// k(z + H) / cosh kH, S = sinh k(z + H) / cosh kH, omega^2 = g k tanh kH, theta = k (x - x0) - omega t:
//
//   eta = sum_k a_k cos theta,                            a_k ~ exp(-(k - k0)^2 (3 lambda / 4)^2 / 2)
//   u = sum (g k / omega) a_k C cos theta,                w = sum (g k / omega) a_k S sin theta
//   displaced by  X = -sum a_k C / tanh kH sin theta,     Z = sum a_k S / tanh kH cos theta
//
// The pressure at a particle is  rho g sum a_k (C - S / tanh kH) cos theta  above the one at rest. The packet starts
// 2.25 lambda before the edge; when it is 1.5 lambda behind it, what was thrown back stands 1.5 lambda before it.
//
// Which way a wave runs is told by elevation and potential together. In a window of length L = 3 lambda on either side
// of the edge, weight sin^2, with whole waves in it, k = 2 pi n / L, n = 2 ... 5, so that the depth falls out:
//
//   eta_k = (2 / L) sum_i V_i sin^2 e^{-ikx},   phi_k = (2 / L) sum_i V_i sin^2 e^{-ikx} (S w - i C u) / tanh kH
//   forth = (eta_k + i (omega / g) phi_k) / 2,   back = (eta_k - i (omega / g) phi_k) / 2
//
// Rotation, which an edge stirs in water at rest too, falls out of phi_k: it is orthogonal to C and S. (Derived here.)
//
// Water at rest with an edge makes waves of its own, of about a hundredth of a spacing. They do not know the packet:
// half the difference of two runs, one with the packet upside down, is what the edge does to the packet. Half the sum
// holds the edge's own waves and what grows with the square of the packet.
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <optional>

#include "base/numbers.h"
#include "sph_solver/effects/forcing_zones.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace surface_wave_reflection_test {

constexpr double g = 9.81, coarse = 0.02;
constexpr double start = 2.25, end = 1.5, window = 2 * end;  // of the packet before and behind the edge, in lambda

enum class Sizes { all_coarse, all_fine, into_fine, out_of_fine };

/// A wall a wave length behind x = 0, and a zone before it.
struct Beach {
    double width = 0;  ///< of the zone, in lambda
    double gamma = 0;  ///< over omega; 0: the wall alone
    static constexpr double wall = 1;
    /// What the wall throws back is here a lambda before x = 0 when the run ends, what a zone does a little farther.
    static constexpr double way = start + 2 * wall + 1;
};

constexpr int first_mode = 2, modes = 4;
/// Complex amplitudes of the waves in a window, over the packet's largest at the start.
using Spectrum = std::array<std::complex<double>, modes>;

/// (a + sign b) / 2.
inline Spectrum half(const Spectrum& a, double sign, const Spectrum& b) {
    Spectrum r;
    for (std::size_t n = 0; n < r.size(); ++n) r[n] = (a[n] + sign * b[n]) / 2.0;
    return r;
}
inline double rms(const Spectrum& s) {
    double sum = 0;
    for (const auto& a : s) sum += std::norm(a);
    return std::sqrt(sum);
}

struct Ways {
    Spectrum back{};   ///< before the edge
    Spectrum forth{};  ///< behind it
};

struct Wave {
    double k, omega, a;  ///< [1/m], [1/s], [m]
    double C(double z, double H) const { return std::cosh(k * (z + H)) / std::cosh(k * H); }
    double S(double z, double H) const { return std::sinh(k * (z + H)) / std::cosh(k * H); }
};

inline std::vector<Wave> waves_of(double lambda, double H, double amplitude) {
    const double k0 = 2 * pi / lambda;
    std::vector<Wave> waves;
    double sum = 0;
    for (int n = 1; n < 60; ++n) {
        const double k = n * k0 / 18, a = std::exp(-0.5 * std::pow((k - k0) * 0.75 * lambda, 2));
        if (a > 1e-4) waves.push_back({k, std::sqrt(g * k * std::tanh(k * H)), a}), sum += a;
    }
    for (Wave& wave : waves) wave.a *= amplitude / sum;
    return waves;
}

struct Packet {
    double length = 0;     ///< of the wave, in coarse spacings
    double steepness = 0;  ///< k a, at most
    double h_over_dp = SphOptions{}.h_over_dp;
    std::optional<Beach> beach = {};
};

/// `sign`: -1 turns the packet upside down.
inline Ways cross(Sizes sizes, const Packet& of, double sign) {
    const double lambda = of.length * coarse, H = lambda / 2, k0 = 2 * pi / lambda,
                 amplitude = sign * of.steepness / k0;
    SimulationSetup s;
    s.dimensions = 2;
    s.threads = 1;
    s.dp = sizes == Sizes::all_coarse ? coarse : coarse / 2;
    s.h_over_dp = of.h_over_dp;
    s.state_equation.c0 = 5 * std::sqrt(g * H);  // nine times the wave's speed
    s.domain = {Vec3(-2 * start * lambda, -1, -H), Vec3(window * lambda, 1, H)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    const double omega0 = std::sqrt(g * k0 * std::tanh(k0 * H));
    if (of.beach) {
        const double wall = s.domain.max.x() = Beach::wall * lambda;
        if (of.beach->gamma > 0)
            s.effects = {ZoneForcing{{{0, true, wall - of.beach->width * lambda, wall, of.beach->gamma * omega0}}}};
    }
    if (sizes == Sizes::into_fine) s.zones = {Zone({Box{Vec3(0, -infinite, -infinite), Vec3::Constant(infinite)}})};
    if (sizes == Sizes::out_of_fine) s.zones = {Zone({Box{Vec3::Constant(-infinite), Vec3(0, infinite, infinite)}})};
    std::vector<Fluid> water = fill_levels(s, {Box{s.domain.min, Vec3(s.domain.max.x(), 1, 0)}});

    const std::vector<Wave> waves = waves_of(lambda, H, amplitude);
    std::vector<std::vector<Vec3>> velocities;  // by level and place
    for (Fluid& fluid : water) {
        std::vector<Vec3>& u = velocities.emplace_back(fluid.places.size(), Vec3::Zero());
        for (std::size_t i = 0; i < u.size(); ++i) {
            Vec3 moved = Vec3::Zero();
            double head = 0;  // pressure over rho g
            for (const Wave& wave : waves) {
                const double z = fluid.places[i].z(), theta = wave.k * (fluid.places[i].x() + start * lambda),
                             tanh = std::tanh(wave.k * H), C = wave.C(z, H), S = wave.S(z, H);
                moved += wave.a / tanh * Vec3(-C * std::sin(theta), 0, S * std::cos(theta));
                u[i] += g * wave.k / wave.omega * wave.a * Vec3(C * std::cos(theta), 0, S * std::sin(theta));
                head += wave.a * (C - S / tanh) * std::cos(theta);
            }
            fluid.places[i] += moved, fluid.depth[i] += head;
        }
    }
    Simulation run(s, water);
    for (std::size_t n = 0; n < velocities.size(); ++n) {
        const FieldsToSet p = run.level(n).fields_to_set();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3& u = velocities[n][static_cast<std::size_t>(p.id[i])];
            p.u[i] = static_cast<float>(u.x()), p.w[i] = static_cast<float>(u.z());
        }
    }
    const double kH = k0 * H, group = std::sqrt(g / k0 * std::tanh(kH)) / 2 * (1 + 2 * kH / std::sinh(2 * kH));
    while (run.time() * group < (of.beach ? Beach::way : start + end) * lambda) run.step();

    const double L = window * lambda;
    const auto read = [&](double from, double way) {
        Spectrum r;
        for (int n = 0; n < modes; ++n) {
            const double k = 2 * pi * (n + first_mode) / L;
            const Wave wave{k, std::sqrt(g * k * std::tanh(k * H)), 0};
            std::complex<double> eta = 0, phi = 0;
            for (const auto& level : run.levels()) {
                const Particles& p = level->fields().particles();
                for (std::size_t i = 0; i < p.size(); ++i) {
                    if (!is_active(p.kind[i]) || p.x[i] < from || p.x[i] > from + L) continue;
                    const double weight = std::pow(std::sin(pi * (p.x[i] - from) / L), 2);
                    const std::complex<double> part =
                        weight * level->system().mass / (s.rho0 + p.drho[i]) * std::polar(1.0, -k * p.x[i]);
                    eta += part;
                    phi += part * std::complex<double>(wave.S(p.z[i], H) * p.w[i], -wave.C(p.z[i], H) * p.u[i]) /
                           std::tanh(k * H);
                }
            }
            r[static_cast<std::size_t>(n)] =
                (eta + way * std::complex<double>(0, wave.omega / g) * phi) / (L * std::abs(amplitude));
        }
        return r;
    };
    return {read(-L, -1), read(0, 1)};
}

struct Reflection {
    Ways of_packet;     ///< half the difference of the two runs
    Spectrum own_back;  ///< half their sum
};
inline Reflection both_ways_up(Sizes sizes, const Packet& of) {
    const Ways up = cross(sizes, of, 1), down = cross(sizes, of, -1);
    return {{half(up.back, -1, down.back), half(up.forth, -1, down.forth)}, half(up.back, 1, down.back)};
}

/// Share of `back` that is the mirror image of the packet `forth`, R eta(-x): the R of least squares.
inline double image(const Spectrum& back, const Spectrum& forth) {
    std::complex<double> product = 0;
    for (std::size_t n = 0; n < back.size(); ++n) product += back[n] * forth[n];
    return std::abs(product) / std::pow(rms(forth), 2);
}

inline void print_head() {
    std::printf(
        "a packet of gravity waves across an edge 2:1, over what one size (that before the edge) leaves of it\n"
        "  length   k a   h/dp               leaves  its image thrown back %%   all odd in it %%   even %%   "
        "through\n");
}
inline void print_line(const char* way, const Packet& of, const Spectrum& left, const Reflection& r) {
    std::printf("  %6.0f  %4.2f  %5.3g  %-11s  %6.3f  %22.2f  %15.2f  %7.2f  %8.3f\n", of.length, of.steepness,
                of.h_over_dp, way, rms(r.of_packet.forth), 100 * image(r.of_packet.back, left),
                100 * rms(r.of_packet.back) / rms(left), 100 * rms(r.own_back) / rms(left),
                rms(r.of_packet.forth) / rms(left));
    std::fflush(stdout);
}

}  // namespace surface_wave_reflection_test
}  // namespace tw
