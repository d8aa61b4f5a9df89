#pragma once
// Water that swings to and fro across both edges of a zone of finer particles: what becomes of the zone's mass.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/numbers.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace levels_test {

inline Zone zone_between(double x0, double x1, double z0, double z1) {
    return Zone({Box{Vec3(x0, -infinite, z0), Vec3(x1, infinite, z1)}});
}

inline Simulation weightless(SimulationSetup s) {
    s.dimensions = 2;
    s.gravity = Vec3::Zero();
    std::vector<Fluid> water = fill_levels(s, {s.domain});
    for (Fluid& fluid : water) fluid.depth.assign(fluid.depth.size(), 0);
    return Simulation(s, water);
}

struct Swing {
    double largest_drift = 0;  ///< of the zone's mass at an instant: a column of its particles is 3 % of it
    double mean_drift = 0, largest_mean = 0;  ///< of the mean over a period, the last and the largest
    double gathered = 0;                      ///< coarse particles under the zone above their number at the start
    double shortfall = 0;                     ///< of the mean velocity behind U sin(omega t), largest, over U
    std::int64_t splits = 0, most_orphans = 0;
};

/// Water between slip walls, periodic along x, that a uniform force rho U omega cos(omega t) swings to and fro across
/// both edges of a zone, 4 coarse spacings to either side. Vortices of `vortices` U stir it at the start.
inline Swing swing(int periods, double vortices) {
    constexpr double U = 0.5, coarse = 0.02, omega = U / (4 * coarse), length = 0.8, height = 0.32;
    SimulationSetup s;
    s.threads = 1;  // of small loops
    s.dp = coarse / 2;
    s.state_equation.c0 = 5;
    s.domain = {Vec3(0, -1, 0), Vec3(length, 1, height)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.mirrors.periodic = {true, false, false};
    s.zones = {zone_between(0.24, 0.56, -infinite, infinite)};
    Simulation simulation = weightless(s);
    for (const auto& level : simulation.levels()) {
        const FieldsToSet p = level->fields_to_set();
        const double kx = 4 * std::numbers::pi / length, kz = std::numbers::pi / height;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.u[i] = static_cast<float>(vortices * U * std::sin(kx * p.x[i]) * std::cos(kz * p.z[i]));
            p.w[i] = static_cast<float>(-vortices * U * kx / kz * std::cos(kx * p.x[i]) * std::sin(kz * p.z[i]));
        }
    }
    const Refinement& edge = simulation.refinements()[0];
    const auto under = [&] {
        return double(std::ranges::count_if(simulation.level(0).fields().particles().kind, stands_for_finer));
    };
    const double under_at_start = under();
    Swing r;
    double impulse = 0;  // of the force that was felt, over the mass
    double sum = 0;      // of the drift, over a period
    int counted = 0, period = 1;
    while (simulation.time() < 2 * std::numbers::pi / omega * periods) {
        const double before = simulation.time(), force = U * omega * std::cos(omega * before);
        simulation.surroundings().gravity.x() = force;
        simulation.step();
        impulse += force * (simulation.time() - before);
        const double drift = edge.mass_drift();
        r.largest_drift = std::max(r.largest_drift, std::abs(drift));
        sum += drift, ++counted;
        if (simulation.time() * omega >= 2 * std::numbers::pi * period) {
            r.mean_drift = sum / counted;
            r.largest_mean = std::max(r.largest_mean, std::abs(r.mean_drift));
            sum = 0, counted = 0, ++period;
        }
        r.most_orphans = std::max(r.most_orphans, edge.ledger().orphans);
        const std::vector<float>& u = simulation.level(0).fields().particles().u;
        const double mean = std::accumulate(u.begin(), u.end(), 0.0) / double(u.size());
        r.shortfall = std::max(r.shortfall, std::abs(mean - impulse) / U);
    }
    r.splits = edge.ledger().splits;
    r.gathered = under() / under_at_start - 1;
    return r;
}

}  // namespace levels_test
}  // namespace tw
