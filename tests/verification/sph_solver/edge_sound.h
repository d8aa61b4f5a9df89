#pragma once
// What edges between sizes of particles throw back of a wave of sound, by its length and angle and their number.
// Two dimensions. A packet of plane waves, periodic along z, meets edges that stand across x:
//
//   rho'/rho0 = d = sin(k . (x - x0)) exp(-(x - x0)^2 / 8 lambda^2),   |k| = 2 pi / lambda,   u = c0 d k/|k|
//
// When it stands as far behind the edges as it began before them, what they have thrown back stands where it began.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/numbers.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace edge_reflection_test {

constexpr double coarse = 0.02, c0 = 20;

struct Packet {
    double back = 0, through = 0;  ///< root mean squares of density, over the packet's at the start
};

/// Lengths in coarse spacings. `rows`: of a period along z; 0: the wave meets the edges squarely. `edges`: at each of
/// them, 10 of its coarser spacings after the one before, the spacing is halved, or doubled where the wave runs out.
inline Packet cross(int edges, double length, double rows, bool into_fine) {
    const double lambda = length * coarse, half = 12 * lambda;
    SimulationSetup s;
    s.dimensions = 2;
    s.threads = 1;
    s.gravity = Vec3::Zero();
    s.dp = std::ldexp(coarse, -edges);
    s.state_equation.c0 = c0;
    s.domain = {Vec3(-half, -1, 0), Vec3(half, 1, (rows > 0 ? rows : 16) * coarse)};
    s.mirrors.on = {{{true, true}, {false, false}, {false, false}}};
    s.mirrors.periodic = {false, false, true};
    double at = 0;
    for (int e = 0; e < edges; ++e) {
        s.zones.push_back(Zone({into_fine ? Box{Vec3(at, -infinite, -infinite), Vec3::Constant(infinite)}
                                          : Box{Vec3::Constant(-infinite), Vec3(-at, infinite, infinite)}}));
        at += 10 * std::ldexp(coarse, -e);
    }
    std::vector<Fluid> water = fill_levels(s, {s.domain});
    for (Fluid& fluid : water) fluid.depth.assign(fluid.depth.size(), 0);
    Simulation run(s, water);

    const double along = rows > 0 ? length / rows : 0;  // sine of the angle
    const Vec3 way(std::sqrt(1 - along * along), 0, along);
    for (const auto& level : run.levels()) {
        const FieldsToSet p = level->fields_to_set();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3 x(p.x[i] + half / 2, 0, p.z[i]);
            const double d = 1e-4 * std::sin(2 * std::numbers::pi / lambda * way.dot(x)) *
                             std::exp(-0.5 * std::pow(x.x() / (2 * lambda), 2));
            p.drho[i] = static_cast<float>(s.rho0 * d);
            p.u[i] = static_cast<float>(c0 * d * way.x()), p.w[i] = static_cast<float>(c0 * d * way.z());
        }
    }
    const auto squares = [&] {
        Packet sum;
        for (const auto& level : run.levels()) {
            const Particles& p = level->fields().particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (!is_active(p.kind[i])) continue;
                (p.x[i] < -2 * lambda ? sum.back : sum.through) +=
                    level->system().mass * std::pow(p.drho[i] / s.rho0, 2);
            }
        }
        return sum;
    };
    const Packet began = squares();
    const double start = began.back + began.through;
    while (c0 * way.x() * run.time() < half) run.step();
    const Packet end = squares();
    return {std::sqrt(end.back / start), std::sqrt(end.through / start)};
}

inline void print(int edges, double length, double rows, const Packet& in, const Packet& out) {
    std::printf("  %6.0f %8.0f %8d %12.4f %9.4f %14.4f %9.4f\n", length,
                rows > 0 ? std::asin(length / rows) * 180 / std::numbers::pi : 0, edges, 100 * in.back, in.through,
                100 * out.back, out.through);
}
inline void print_head() {
    std::printf(
        "a packet of sound across edges 2:1; root mean squares over the packet's\n"
        "  length    angle    edges   in: back %%   through   out: back %%   through\n");
}

}  // namespace edge_reflection_test
}  // namespace tw
