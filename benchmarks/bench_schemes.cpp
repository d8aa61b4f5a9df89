// Time-stepping schemes, error against cost: each scheme at several Courant numbers on two-dimensional cases with an
// exact answer. Prints the table of docs/results/numerics.md; one core, some minutes.
//
//   sound     a standing wave of sound in a closed box, no dissipation: the box of particles has one frequency, which
//             the smallest step of the most accurate scheme finds; what is left is the error in time
//   vortex    a cell of rotating water in a closed box. Pair sums of continuity and pressure are dual, so without
//             dissipation (alpha = delta = 0, no shifting) the energy stays, but for the time integrator: what that
//             gives to the water, over what alpha and delta dissipate in the same time when they are on
//   drop      elliptic drop (Monaghan 1994): semi-axes when it is four times as high as wide
//   tank      water at rest with a free surface: kinetic energy over rho g H V, pressure over rho g H
//   wedge     30 degrees of deadrise entering water: force over the similarity solution's 14.02 rho V^3 t
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/mass_properties.h"
#include "sph_solver/simulation.h"

using namespace tw;

namespace {

struct How {
    Scheme scheme = Scheme::symplectic_euler;
    double cfl = 0.7;
};

const char* name_of(Scheme scheme) {
    switch (scheme) {
        case Scheme::symplectic_euler: return "symplectic Euler";
        case Scheme::kick_drift_kick: return "kick-drift-kick";
        case Scheme::predictor_corrector: return "predictor-corrector";
        case Scheme::rk4_frozen_diffusion: return "RK4, frozen diffusion";
    }
    return "";
}

/// What all cases have in common: evaluations and processor time per simulated second.
struct SchemeCost {
    double evaluations = 0, seconds = 0, simulated = 0;
};
SchemeCost total;  // of the row being made

SimulationSetup setup_of(const How& how, double dp) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.scheme = how.scheme;
    s.cfl = how.cfl;
    s.threads = 1;
    return s;
}

/// Steps until `end`, with a look after each. A run whose step falls to a twentieth of the acoustic one is not waited
/// for: these cases have no such accelerations, it has lost its stability.
template <class Look>
void run(Simulation& simulation, double end, Look look) {
    const std::clock_t start = std::clock();
    while (simulation.time() < end) {
        simulation.step();
        const double acoustic = simulation.setup().cfl * simulation.h() / simulation.setup().state_equation.c0;
        if (simulation.dt() < acoustic / 20) throw RunError("unstable");
        look();
    }
    total.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
    total.evaluations += double(simulation.timers().evaluations) / double(simulation.particles().size());
}

/// A box full of water between mirrors, no gravity.
SimulationSetup closed_box(const How& how, double dp, double length, double height, double c0) {
    SimulationSetup s = setup_of(how, dp);
    s.state_equation.c0 = c0;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(0, -1, 0), Vec3(length, 1, height)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    return s;
}
Fluid still(const SimulationSetup& s, const Box& block) {
    Fluid water = fill_with_fluid(s, {block});
    for (double& depth : water.depth) depth = 0;
    return water;
}

/// Angular frequency of the first mode of sound in a box of length 1 [rad/s], c0 = 20 m/s.
double sound_frequency(const How& how) {
    SimulationSetup s = closed_box(how, 1.0 / 20, 1, 0.5, 20);
    s.alpha = s.delta = s.shifting = 0;
    Simulation simulation(s, still(s, s.domain));
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) p.u[i] = static_cast<float>(1e-3 * std::sin(pi * p.x[i]));
    std::vector<double> zeros;
    double before = 0, then = 0;
    run(simulation, 20 * 2 / 20.0, [&] {
        double now = 0;
        for (std::size_t i = 0; i < p.size(); ++i) now += double(p.u[i]) * std::sin(pi * p.x[i]);
        if (before * now < 0) zeros.push_back(then + (simulation.time() - then) * before / (before - now));
        before = now, then = simulation.time();
    });
    return pi * double(zeros.size() - 1) / (zeros.back() - zeros.front());
}

/// Energy of a vortex cell after 0.3 m of its fastest water's way, over the start's.
double vortex_energy(const How& how, bool dissipation) {
    SimulationSetup s = closed_box(how, 1.0 / 32, 1, 1, 15);
    if (!dissipation) s.alpha = s.delta = s.shifting = 0;
    Simulation simulation(s, still(s, s.domain));
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = static_cast<float>(std::sin(pi * p.x[i]) * std::cos(pi * p.z[i]));
        p.w[i] = static_cast<float>(-std::cos(pi * p.x[i]) * std::sin(pi * p.z[i]));
        // the pressure that turns it, rho U^2 (cos 2 pi x + cos 2 pi z) / 4, or sound would fill the box; 1 kPa above
        const double pressure = s.rho0 / 4 * (std::cos(2 * pi * p.x[i]) + std::cos(2 * pi * p.z[i])) + 1000;
        p.drho[i] = s.state_equation.deviation(s.rho0, pressure);
    }
    const double c0 = s.state_equation.c0;
    // With one evaluation a step densities are known half a step before velocities: the kinetic energy of the step
    // before belongs to the mean of its elastic energy and this one's.
    const bool staggered = how.scheme == Scheme::symplectic_euler || how.scheme == Scheme::kick_drift_kick;
    double first = 0, last = 0, firsts = 0, lasts = 0, kinetic_before = 0, elastic_before = 0;
    const double end = 0.3;
    run(simulation, end, [&] {
        double kinetic = 0, elastic = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double r = double(p.drho[i]) / s.rho0;
            kinetic += (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]) / 2;
            elastic += c0 * c0 * (std::log1p(r) - r / (1 + r));
        }
        const double energy = staggered ? kinetic_before + (elastic_before + elastic) / 2 : kinetic + elastic;
        kinetic_before = kinetic, elastic_before = elastic;
        if (simulation.steps() == 1) return;
        if (simulation.time() < 0.05 * end) first += energy, firsts += 1;
        if (simulation.time() > 0.95 * end) last += energy, lasts += 1;
    });
    return last / lasts / (first / firsts);
}

/// Larger one of the relative errors of the semi-axes.
double drop_error(const How& how) {
    constexpr double A = 100, end = 0.0076, exact_x = 0.5142664744, exact_z = 1.944517191;
    SimulationSetup s = setup_of(how, 1.0 / 30);
    s.state_equation.c0 = 1400;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(-4, -1, -4), Vec3(4, 1, 4)};
    Fluid drop;
    for (const Vec3& place : fill_with_fluid(s, {Box{Vec3(-1, 0, -1), Vec3(1, 0, 1)}}).places)
        if (std::hypot(place.x(), place.z()) < 1) drop.places.push_back(place), drop.depth.push_back(0);
    Simulation simulation(s, drop);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i)
        p.u[i] = static_cast<float>(-A * p.x[i]), p.w[i] = static_cast<float>(A * p.z[i]);
    // the axes at `end` itself, between two steps
    double a = 0, b = 0, a0 = 0, b0 = 0, t0 = 0;
    run(simulation, end, [&] {
        double xx = 0, zz = 0;
        for (std::size_t i = 0; i < p.size(); ++i) xx += p.x[i] * p.x[i], zz += p.z[i] * p.z[i];
        const double n = static_cast<double>(p.size());
        if (simulation.time() < end) a0 = 2 * std::sqrt(xx / n), b0 = 2 * std::sqrt(zz / n), t0 = simulation.time();
        a = 2 * std::sqrt(xx / n), b = 2 * std::sqrt(zz / n);
    });
    const double share = (end - t0) / (simulation.time() - t0);
    return std::max(std::abs((a0 + share * (a - a0)) / exact_x - 1), std::abs((b0 + share * (b - b0)) / exact_z - 1));
}

struct Rest {
    double kinetic = 0, pressure = 0;  ///< mean of the second half over rho g H V; root mean square over rho g H
};
Rest tank(const How& how, double end) {
    constexpr double g = 9.81;
    SimulationSetup s = setup_of(how, 0.05);
    s.state_equation.c0 = 10 * std::sqrt(g);
    s.domain = {Vec3(0, -1, -1), Vec3(2, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Simulation simulation(s, fill_with_fluid(s, {Box{s.domain.min, Vec3(2, 1, 0)}}));
    const Particles& p = simulation.particles();
    const double n = static_cast<double>(p.size());
    Rest r;
    double samples = 0;
    run(simulation, end, [&] {
        if (simulation.time() < end / 2 || simulation.steps() % 10 != 0) return;
        samples += 1;
        for (std::size_t i = 0; i < p.size(); ++i) {
            r.kinetic += (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]) / 2 / (g * n);
            r.pressure += std::pow((simulation.pressure(i) + s.rho0 * g * p.z[i]) / (s.rho0 * g), 2) / n;
        }
    });
    r.kinetic /= samples, r.pressure = std::sqrt(r.pressure / samples);
    return r;
}

/// A wedge along y, section counter-clockwise seen from -y.
Surface wedge_of(double half_width, double height) {
    Surface s;
    for (const double y : {-3.0, 3.0})
        for (const auto& [x, z] : {std::pair{0.0, 0.0}, {half_width, height}, {-half_width, height}})
            s.points.emplace_back(x, y, z);
    s.triangles = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}, {0, 2, 1}, {3, 4, 5}};
    if (mass_properties(s).volume < 0)
        for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

/// Force over rho V^3 t, by the impulse between 0.4 and 1 of the time. The wedge is fixed, the water comes.
double wedge_force(const How& how) {
    constexpr double V = 1, x_root = 2.722973, y_tip = 1.83295, root = 1.0 / 3, fineness = 26, sound = 15;
    const double until = root / (x_root * V), slope = std::tan(pi / 6);
    SimulationSetup s = setup_of(how, root / fineness);
    s.state_equation.c0 = sound * x_root * V;
    s.gravity = Vec3::Zero();
    const double half = std::round(0.53 * sound * fineness) * s.dp;
    const double height = std::min(1.3 * (1 + y_tip) * V * until, 1.5 * half * slope);
    s.domain = {Vec3(0, -1, -1.5 * half), Vec3(2 * half, 1, half)};
    s.mirrors.on[0][0] = true;
    s.bodies = {wedge_of(height / slope, height)};
    Simulation simulation(s, still(s, Box{Vec3(0, 0, -half), Vec3(half, 0, 0)}));
    for (float& w : simulation.fields_to_set().w) w = static_cast<float>(V);
    double impulse = 0, before = 0, t1 = 0, impulse1 = 0;
    run(simulation, until, [&] {
        impulse += simulation.load().force.z() * (simulation.time() - before);
        before = simulation.time();
        if (before <= 0.4 * until) t1 = before, impulse1 = impulse;
    });
    return 2 * (impulse - impulse1) / (s.rho0 * V * V * V / 2 * (before * before - t1 * t1));
}

/// Largest Courant number, in steps of 0.1, up to which the tank stays at rest and its pressure hydrostatic for 10 s.
double largest_stable(Scheme scheme, double from) {
    double stable = 0;
    for (double cfl = from; cfl < 3.05; cfl += 0.1) {
        try {
            const Rest r = tank({scheme, cfl}, 10);
            if (!(r.kinetic < 1e-4 && r.pressure < 0.02)) break;
        } catch (const RunError&) { break; }
        stable = cfl;
    }
    return stable;
}

template <class Case>
double or_nan(Case of) {
    try {
        return of();
    } catch (const RunError&) { return NAN; }
}

}  // namespace

int main() {
    const struct {
        Scheme scheme;
        std::vector<double> courants;
    } plan[] = {{Scheme::symplectic_euler, {0.35, 0.7, 0.9, 1.2}},
                {Scheme::kick_drift_kick, {0.35, 0.7, 0.9, 1.2}},
                {Scheme::predictor_corrector, {0.2, 0.35, 0.7}},
                {Scheme::rk4_frozen_diffusion, {0.7, 1.4, 2.0}}};
    const How smallest{Scheme::rk4_frozen_diffusion, 0.2};
    const double sound = sound_frequency(smallest), dissipated = 1 - vortex_energy(smallest, true);
    std::printf("sound in the box of particles: %.4f of c0; the vortex dissipates %.2f %% of its energy\n",
                sound / (20 * pi), 100 * dissipated);
    std::printf("%-22s %5s %8s | %9s %9s %7s %9s %7s %7s | %11s %7s\n", "scheme", "C", "stable", "sound", "vortex",
                "drop", "tank E", "tank p", "wedge", "evaluations", "CPU s");
    double unit = 0;
    for (const auto& [scheme, courants] : plan) {
        const double stable = largest_stable(scheme, 0.3);
        for (const double cfl : courants) {
            const How how{scheme, cfl};
            total = {};
            const double f = or_nan([&] { return sound_frequency(how); }) / sound - 1;
            const double e = or_nan([&] { return vortex_energy(how, false); }) - 1;
            const double d = or_nan([&] { return drop_error(how); });
            Rest r{NAN, NAN};
            try {
                r = tank(how, 20);
            } catch (const RunError&) {}
            const double w = or_nan([&] { return wedge_force(how); });
            if (unit == 0) unit = total.evaluations;
            std::printf("%-22s %5.2f %8.1f | %+8.3f%% %+8.1f%% %6.2f%% %9.1e %6.2f%% %7.2f | %11.2f %7.1f\n",
                        name_of(scheme), cfl, stable, 100 * f, 100 * e / dissipated, 100 * d, r.kinetic,
                        100 * r.pressure, w, total.evaluations / unit, total.seconds);
            std::fflush(stdout);
        }
    }
}
