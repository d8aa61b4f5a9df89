// Levels of particle size against what is exact: an edge between two sizes is to be felt by nothing that crosses it.
// Two dimensions. Read off runs of one size, and of a size that changes, of the same case.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include <Eigen/Dense>

#include "base/numbers.h"
#include "bodies.h"
#include "tests/verification/sph_solver/zone_swing.h"

namespace tw {
namespace levels_test {

// A uniform stream keeps its velocity and pressure through three sizes of particles, and nothing is lost: the lattice
// of the daughters is the fine lattice, and linear fields are interpolated exactly.
TEST(LevelEdge, AUniformStreamCrossesItUnchanged) {
    SimulationSetup s;
    s.dp = 0.01;
    s.state_equation.c0 = 10;
    s.domain = {Vec3(0, -1, 0), Vec3(3.2, 1, 1.6)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.mirrors.periodic = {true, false, false};
    s.zones = {zone_between(0.6, 2.6, 0.3, 1.3), zone_between(1.2, 2, 0.6, 1)};
    Simulation simulation = weightless(s);
    for (const auto& level : simulation.levels()) std::ranges::fill(level->fields_to_set().u, 1.0f);
    while (simulation.time() < 1) simulation.step();  // through the inner zone
    for (const auto& level : simulation.levels()) {
        const Particles& p = level->fields().particles();
        double du = 0, pressure = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i])) continue;
            du = std::max(du, std::hypot(double(p.u[i]) - 1, double(p.w[i])));
            pressure = std::max(pressure, std::abs(level->fields().pressure(i)) / (s.rho0 * 1));
        }
        EXPECT_LT(du, 1e-4);        // found 2e-6
        EXPECT_LT(pressure, 1e-4);  // of rho U^2; found 1e-5
    }
    for (const Refinement& edge : simulation.refinements()) {
        EXPECT_GT(edge.ledger().splits, 3000);
        EXPECT_EQ(edge.ledger().orphans, 0);
        const Box& zone = edge.zone().boxes().front();
        const double column =
            edge.coarse().system().setup.dp * zone.size().z();  // it has crossed the edge in one level first
        EXPECT_LE(std::abs(edge.surplus()), 1.001 * s.rho0 * column);
    }
}

struct Crossing {
    double back = 0, through = 0;  ///< largest density of the waves either way over the pulse's
};

/// A weak pulse of sound, standard deviation `width` coarse spacings, that crosses the edge at x = 2 from either side.
/// Characteristics: the wave to the right is (rho' / rho0 + u / c0) / 2, that to the left the difference.
Crossing pulse(int levels, double width, bool into_fine) {
    constexpr double c0 = 20, strength = 1e-4, coarse = 0.02;
    SimulationSetup s;
    s.dp = coarse / (levels == 2 ? 2 : 1);
    s.state_equation.c0 = c0;
    s.domain = {Vec3(0, -1, 0), Vec3(4, 1, 16 * coarse)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, true}}};
    if (levels == 2) s.zones = {zone_between(2, infinite, -infinite, infinite)};
    Simulation simulation = weightless(s);
    const double start = into_fine ? 1.2 : 2.8, direction = into_fine ? 1 : -1;
    for (const auto& level : simulation.levels()) {
        const FieldsToSet p = level->fields_to_set();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double f = strength * std::exp(-0.5 * std::pow((p.x[i] - start) / (width * coarse), 2));
            p.drho[i] = static_cast<float>(s.rho0 * f), p.u[i] = static_cast<float>(direction * c0 * f);
        }
    }
    while (c0 * simulation.time() < 1.6) simulation.step();
    Crossing r;
    for (const auto& level : simulation.levels()) {
        const Particles& p = level->fields().particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i])) continue;
            const double d = p.drho[i] / s.rho0, u = direction * p.u[i] / c0;
            const bool before = (p.x[i] < 2) == into_fine;
            if (before)
                r.back = std::max(r.back, std::abs(d - u) / 2 / strength);
            else
                r.through = std::max(r.through, (d + u) / 2 / strength);
        }
    }
    return r;
}

TEST(LevelEdge, ReflectsLittleOfASoundPulse) {
    std::printf(
        "a pulse of sound across an edge 2:1; density of what comes back and what goes through, over the pulse's\n");
    std::printf(
        "  width/dp coarse   one size: back  through | into fine: back  through | out of fine: back  through\n");
    for (const double width : {3.0, 6.0, 12.0}) {
        const Crossing uniform = pulse(1, width, true), in = pulse(2, width, true), out = pulse(2, width, false);
        std::printf("  %8.0f           %14.5f  %7.4f | %15.5f  %7.4f | %17.5f  %7.4f\n", width, uniform.back,
                    uniform.through, in.back, in.through, out.back, out.through);
        EXPECT_LT(in.back, 0.004) << width;
        EXPECT_LT(out.back, 0.005) << width;
        EXPECT_GT(in.through, uniform.through - 0.005) << width;
    }
}

/// A standing wave of length 1 m in water 1 m deep, started flat with the velocities of linear theory, amplitude 0.3
/// m/s at the surface, after 0.15 s (a fifth of its period). The zone's edges stand where the surface is steepest.
Simulation wave(int levels) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.02;
    s.state_equation.c0 = 10 * std::sqrt(9.81);
    s.domain = {Vec3(0, -1, -1), Vec3(2, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    if (levels == 2) s.zones = {zone_between(0.6, 1.4, -0.6, infinite)};
    Simulation simulation(s, fill_levels(s, {Box{s.domain.min, Vec3(2, 1, 0)}}));
    const double k = 2 * std::numbers::pi;
    for (const auto& level : simulation.levels()) {
        const FieldsToSet p = level->fields_to_set();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double a = 0.3 / std::cosh(k), up = k * (p.z[i] + 1);
            p.u[i] = static_cast<float>(a * std::cosh(up) * std::sin(k * p.x[i]));
            p.w[i] = static_cast<float>(-a * std::sinh(up) * std::cos(k * p.x[i]));
        }
    }
    while (simulation.time() < 0.15) simulation.step();
    return simulation;
}

/// Velocity at a place from the six nearest particles, fitted linearly.
Eigen::RowVector2d velocity_near(const Particles& p, const Vec3& x) {
    constexpr std::size_t of = 6;
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), 0);
    const auto distance = [&](std::size_t i) { return std::hypot(p.x[i] - x.x(), p.z[i] - x.z()); };
    std::ranges::partial_sort(order, order.begin() + of, {}, distance);
    Eigen::Matrix<double, of, 3> A;
    Eigen::Matrix<double, of, 2> u;
    for (std::size_t n = 0; n < of; ++n) {
        const std::size_t i = order[n];
        const auto row = static_cast<Eigen::Index>(n);
        A.row(row) << 1, p.x[i] - x.x(), p.z[i] - x.z();
        u.row(row) << p.u[i], p.w[i];
    }
    return A.colPivHouseholderQr().solve(u).row(0);
}

// Under the surface the water near an edge moves as it does in particles of the fine size. 0.039 m/s with the band
// compressed by its own sums in the uppermost row too, which made the water leave the fine level there; 0.018 with the
// pressures of the uppermost rows handed over as they are.
TEST(LevelEdge, AWaveCrossesItAsItCrossesWaterOfOneSize) {
    const Simulation one = wave(1), two = wave(2);
    double sum = 0, sum_deep = 0;
    int n = 0, n_deep = 0;
    for (const auto& level : two.levels()) {
        const Particles& p = level->fields().particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i]) || std::abs(p.x[i] - 0.6) > 0.2) continue;
            const auto expected = velocity_near(one.level(0).fields().particles(), Vec3(p.x[i], 0, p.z[i]));
            const double error = std::hypot(p.u[i] - expected[0], p.w[i] - expected[1]);
            if (p.z[i] > -0.09) sum += error * error, ++n;
            if (p.z[i] < -0.2 && p.z[i] > -0.5) sum_deep += error * error, ++n_deep;
        }
    }
    const double error = std::sqrt(sum / n), deep = std::sqrt(sum_deep / n_deep);
    std::printf(
        "a wave of 0.3 m/s across an edge: mean square difference from one size %.4f m/s under the surface, "
        "%.4f m/s below\n",
        error, deep);
    EXPECT_LT(error, 0.0095);
    EXPECT_LT(deep, 0.003);
}

// Water whose kernel sums are smaller takes a larger pressure gradient to carry itself: where one size has fewer
// particles to a volume than the other it sinks between the other's. While buffer particles spread outwards the fine
// particles' rms was 0.018; one size is at 0.002 to 0.004 from the giving way of its lattice.
TEST(LevelEdge, StillWaterAcrossTheSurfaceStaysSlow) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.02;
    s.state_equation.c0 = 10 * std::sqrt(9.81);
    s.domain = {Vec3(0, -1, -1), Vec3(2, 1, 1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    s.zones = {zone_between(0.6, 1.4, -0.6, infinite)};
    Simulation simulation(s, fill_levels(s, {Box{s.domain.min, Vec3(2, 1, 0)}}));
    const double under = s.rho0 * 0.8 * 0.6, at_start = simulation.refinements()[0].surplus();
    double fastest = 0, squares = 0;
    int times = 0;
    while (simulation.time() < 5) {
        simulation.step();
        if (simulation.steps() % 20 != 0) continue;
        for (const auto& level : simulation.levels()) fastest = std::max(fastest, level->system().extremes.speed);
        if (simulation.time() > 2) squares += mean_square_velocity(simulation.finest()), ++times;
    }
    const double wave_speed = std::sqrt(9.81), rms = std::sqrt(squares / times) / wave_speed;
    const double drift = (simulation.refinements()[0].surplus() - at_start) / under;
    std::printf(
        "still water with an edge across its surface, 5 s, over sqrt(g H): fine particles' rms from 2 s on %.4f, "
        "fastest "
        "%.3f; mass of the zone %+.1f %%\n",
        rms, fastest / wave_speed, 100 * drift);
    EXPECT_LT(rms, 0.015);
    EXPECT_LT(std::abs(drift), 0.04);
    for (const auto& level : simulation.levels()) EXPECT_EQ(level->system().ledger.lost, 0);
}

// Archimedes for a body that an edge cuts in two: each size bears the water that it has, and none is counted twice.
TEST(LevelEdge, ABodyAcrossItIsBorneByBothSizes) {
    SimulationSetup s = tank(0.01, 0.8, 0.8, 0.3, 25);
    s.bodies = {box_body(0.4, 0.24, 0.48, 1000)};
    s.bodies[0].moving.reset();
    s.zones = {zone_between(0.04, infinite, -infinite, infinite)};
    s.partial_zones = 1;
    Box below = s.domain;
    below.max.z() = 0;
    Simulation still(s, fill_levels(s, {below}));
    Vec3 sum = Vec3::Zero();
    int steps = 0;
    while (still.time() < 0.3) {
        still.step();
        if (still.time() < 0.1) continue;
        sum += still.load().force;
        ++steps;
    }
    const double lift = sum.z() / steps, weight = 1000 * 9.81 * 0.4 * 0.24;
    std::printf("a body across an edge: lift %.4f of the weight of its water, sideways %.4f\n", lift / weight,
                sum.x() / steps / weight);
    EXPECT_NEAR(lift / weight, 1, 0.03);
    EXPECT_NEAR(sum.x() / steps / weight, 0, 0.03);
}

// A zone is to keep its mass in a flow that turns round between the places where daughters are born and where they die:
// 0.5 % are asked for. It does not: what comes back is not quite what went. While nothing but the fine level's
// velocities told the carried particles where to go, they gathered under the zone (4 % in 30 periods, 10 % in 60), the
// water outside thinned, and the zone with it: 16 to 26 % in a hundred.
TEST(LevelEdge, AFlowThatTurnsRoundLeavesMostOfAZonesMass) {
    const Swing r = swing(30, 0.1);
    std::printf(
        "30 swings across an edge: mass of the zone %+.1f %% in the last, %.1f %% in a swing's mean and %.1f %% at an "
        "instant at most; coarse particles under it %+.1f %%; mean velocity off by %.3f U; %ld births, %ld orphans at "
        "once at most\n",
        100 * r.mean_drift, 100 * r.largest_mean, 100 * r.largest_drift, 100 * r.gathered, r.shortfall, long(r.splits),
        long(r.most_orphans));
    EXPECT_GT(r.splits, 10000);
    EXPECT_LT(std::abs(r.gathered), 0.03);
    EXPECT_LT(r.largest_mean, 0.025);  // 3.1 % while parents that had been 4.1 to 4.5 dp away kept lost daughters lost
    EXPECT_LT(r.most_orphans, 30);
    EXPECT_LT(r.shortfall, 0.1);
}

struct Vortex {
    double energy = 0;    ///< of what moves beside the stream, over that at the start
    double x = 0, z = 0;  ///< centre of that energy [m]
};

/// A vortex without circulation, u_theta = 0.3 U (r / R) exp((1 - r^2 / R^2) / 2), R = 0.08 m, that a stream of U = 1
/// m/s carries from x = 0.4 to 1.2 m, right through the zone where there is one.
Vortex carried_vortex(double dp, std::vector<Zone> zones) {
    constexpr double U = 1, R = 0.08;
    SimulationSetup s;
    s.dp = dp;
    s.state_equation.c0 = 10;
    s.domain = {Vec3(0, -1, 0), Vec3(1.6, 1, 0.8)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.mirrors.periodic = {true, false, false};
    s.zones = std::move(zones);
    Simulation simulation = weightless(s);
    const auto now = [&] {
        Vortex v;
        for (const auto& level : simulation.levels()) {
            const Particles& p = level->fields().particles();
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (!is_active(p.kind[i])) continue;
                const double e = level->system().mass * (std::pow(p.u[i] - U, 2) + std::pow(double(p.w[i]), 2));
                v.energy += e, v.x += e * p.x[i], v.z += e * p.z[i];
            }
        }
        v.x /= v.energy, v.z /= v.energy;
        return v;
    };
    for (const auto& level : simulation.levels()) {
        const FieldsToSet p = level->fields_to_set();
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double x = p.x[i] - 0.4, z = p.z[i] - 0.4;
            const double turn = 0.3 * U / R * std::exp((1 - (x * x + z * z) / (R * R)) / 2);
            p.u[i] = static_cast<float>(U - turn * z), p.w[i] = static_cast<float>(turn * x);
        }
    }
    const double at_start = now().energy;
    while (simulation.time() < 0.8 / U) simulation.step();
    Vortex v = now();
    v.energy /= at_start;
    return v;
}

// A vortex that goes in at one edge and out at the other keeps its way. The interpolation smooths it at each edge:
// waves of number k lose 0.133 (k h)^2 of their amplitude, h = 1.2 spacings of the side that lends. With h = 1.5 the
// energy left of a vortex whose radius is four coarse spacings was 0.75.
TEST(LevelEdge, AVortexIsCarriedThroughAZone) {
    const Vortex coarse = carried_vortex(0.02, {}), fine = carried_vortex(0.01, {}),
                 both = carried_vortex(0.01, {zone_between(0.6, 1, 0.2, 0.6)});
    std::printf("a vortex carried through a zone: energy left, centre [m]\n");
    for (const auto& [name, v] : {std::pair{"one size, coarse", coarse}, std::pair{"one size, fine", fine},
                                  std::pair{"fine in the zone", both}})
        std::printf("  %s  %.3f  %.4f  %.4f\n", name, v.energy, v.x, v.z);
    EXPECT_GT(both.energy, coarse.energy - 0.055);  // found 0.03 below
    EXPECT_LT(both.energy, fine.energy);
    EXPECT_NEAR(both.x, coarse.x, 0.01);  // half a coarse spacing; found 0.005
    EXPECT_NEAR(both.z, coarse.z, 0.01);  // found 0.006
}

}  // namespace levels_test
}  // namespace tw
