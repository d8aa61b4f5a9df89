// What the equations conserve: mass, momentum, angular momentum; and where the energy goes.
//
// Energy per mass of the linear state equation, p = c0^2 (rho - rho0), de = p / rho^2 drho:
//
//   e(rho) = c0^2 (ln(rho / rho0) + rho0 / rho - 1)
//
// Divergence and pressure gradient are dual sums over the pairs, so what the pressure does to the motion it takes from
// e (Antuono, Marrone, Colagrossi & Bouscasse 2015, doi:10.1016/j.cma.2015.02.004). All else is dissipation of a named
// term. One step from (x, u, rho) by dt, the step before having been dt', with V = m / rho. Symplectic Euler has d = 0,
// k = dt, e = dt; kick-drift-kick d = dt'/2, k = (dt' + dt)/2, e = dt/2:
//
//   rho* = rho + dt' rho_i sum_j (u_i - u_j) . grad_i W_ij V_j               exchange, elastic side
//   the rise of rho* times clamp((Q_i - 0.8) / 0.1, 0, 1) there, Q_i the kernel support with a plane surface's share
//   given back, where that support is below 0.9                              a void closes first: not stored in e
//   rho* -> rho0 where the kernel support is below 0.9 and rho* < rho0       no tension at a surface: e(rho) lost
//   x += d u                                                                 gravity's work, as at the end
//   a = -1/rho_i sum_j (p_i + p_j) grad_i W_ij V_j                           exchange, kinetic side
//       + alpha h c0 rho0 / rho_i sum_j pi_ij grad_i W_ij V_j + g            artificial viscosity; gravity
//   drho = k delta h c0 sum_j psi_ij . grad_i W_ij V_j                       density diffusion
//        + k c0/h rho0 e_i beside a solid (packing.h)                        density follows packing
//   u += k a;  x += e u + shift                                              shifting lifts water
//
// Behind a mirror plane p_j holds rho0 g . (x_image - x_j) more than the source's pressure: work of a wall that stands
// still. A solid floor adds, over its dummy particles d at a water particle with the wall's normal n = (0, 0, 1),
//
//   drho_i/dt: rho_i sum_d (u_i . n) n . grad_i W_id V_d, where it compresses times (support - 0.9) / 0.1
//   a_i:      -1/rho_i sum_d (p_i + p_d) grad_i W_id V_d,  p_d = sum_f (p_f + rho_f g . (x_d - x_f)) V W / sum_f V W
//
// and its work should be zero too. What it stops as the last resort ("held") loses energy.
//
// Exchange is exact in continuous time; a scheme takes its two sides at other moments, and gravity's work likewise: the
// time integrator's part. The sums are done here anew, over all pairs, in double precision; what
// the engine's own state has lost is compared with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "elliptic_drop.h"
#include "prism.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/equations/packing.h"
#include "sph_solver/equations/water_completeness.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace conservation_test {

/// Energies [J] and momenta [N s], [N m s] per metre of width.
struct Sums {
    double kinetic = 0, potential = 0, elastic = 0, x = 0, z = 0, turn = 0;
    double energy() const { return kinetic + potential + elastic; }
};

double elastic_energy(const SimulationSetup& s, double drho) {
    const double c0 = s.state_equation.c0, r = drho / s.rho0;
    return c0 * c0 * (std::log1p(r) - r / (1 + r));
}

Sums sums_of(const Simulation& simulation, const Particles& p) {
    Sums s;
    const double m = simulation.mass(), g = simulation.setup().gravity.z();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double u = p.u[i], w = p.w[i];
        s.kinetic += m / 2 * (u * u + w * w);
        s.potential -= m * g * p.z[i];
        s.elastic += m * elastic_energy(simulation.setup(), p.drho[i]);
        s.x += m * u, s.z += m * w;
        s.turn += m * (p.z[i] * u - p.x[i] * w);
    }
    return s;
}

/// Energy that each term has given to the water since the start [J]: what dissipates is negative.
struct Budget {
    double viscosity = 0, diffusion = 0, tension = 0, shifting = 0, planes = 0, integrator = 0;
    double solid = 0, held = 0, voids = 0, packing = 0;
    double shifting_turn = 0;  ///< angular momentum by shifting [N m s]
    double sum() const {
        return viscosity + diffusion + tension + voids + shifting + planes + integrator + solid + held + packing;
    }
    double dissipated() const { return -(viscosity + diffusion + tension + voids + held); }
};

/// A neighbour of a particle: particle j, or its image in mirror planes.
struct Neighbour {
    std::size_t j;
    double x, z;                ///< r_ji
    double F, W;                ///< grad_i W_ij = F r_ji
    double mirror_x, mirror_z;  ///< -1 where the image's motion is reversed
    double higher;              ///< pressure of the image above the source's [Pa]
};

/// A dummy particle of a solid near a particle.
struct WallNeighbour {
    std::size_t d;
    double x, z, F, W, volume;
};
std::vector<std::vector<WallNeighbour>> wall_of(const Simulation& simulation, const Particles& p,
                                                const Dummies& floor) {
    const double h = simulation.h(), sigma = 7 / (4 * std::numbers::pi * h * h);
    std::vector<std::vector<WallNeighbour>> all(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t d = 0; d < floor.places.size(); ++d) {
            const double x = floor.places[d].x() - p.x[i], z = floor.places[d].z() - p.z[i], r2 = x * x + z * z;
            if (r2 >= 4 * h * h) continue;
            const double r = std::sqrt(r2) / h, t = 1 - r / 2;
            all[i].push_back(
                {d, x, z, 5 * sigma / (h * h) * t * t * t, sigma * t * t * t * t * (2 * r + 1), floor.volumes[d]});
        }
    return all;
}

/// All pairs within 2h, by comparing every two places.
std::vector<std::vector<Neighbour>> neighbours_of(const Simulation& simulation, const Particles& p) {
    const SimulationSetup& s = simulation.setup();
    const double h = simulation.h(), sigma = 7 / (4 * std::numbers::pi * h * h);
    struct Place {
        std::size_t j;
        double x, z, mirror_x, mirror_z;
    };
    std::vector<Place> places;
    for (std::size_t j = 0; j < p.size(); ++j)
        for (int a = 0; a < 3; ++a)  // itself, its image at the low face, at the high face
            for (int b = 0; b < 3; ++b) {
                Place q{j, p.x[j], p.z[j], 1, 1};
                if ((a && !s.mirrors.on[0][static_cast<std::size_t>(a - 1)]) ||
                    (b && !s.mirrors.on[2][static_cast<std::size_t>(b - 1)]))
                    continue;
                if (a) q.x = 2 * (a == 1 ? s.domain.min : s.domain.max).x() - q.x, q.mirror_x = -1;
                if (b) q.z = 2 * (b == 1 ? s.domain.min : s.domain.max).z() - q.z, q.mirror_z = -1;
                if (s.domain.min.x() - 2 * h < q.x && q.x < s.domain.max.x() + 2 * h &&
                    s.domain.min.z() - 2 * h < q.z && q.z < s.domain.max.z() + 2 * h)
                    places.push_back(q);
            }
    std::vector<std::vector<Neighbour>> all(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        for (const Place& q : places) {
            const double x = q.x - p.x[i], z = q.z - p.z[i], r2 = x * x + z * z;
            if (r2 >= 4 * h * h) continue;
            const double r = std::sqrt(r2) / h, t = 1 - r / 2;
            all[i].push_back({q.j, x, z, 5 * sigma / (h * h) * t * t * t, sigma * t * t * t * t * (2 * r + 1),
                              q.mirror_x, q.mirror_z,
                              s.rho0 * (s.gravity.x() * (q.x - p.x[q.j]) + s.gravity.z() * (q.z - p.z[q.j]))});
        }
    return all;
}

/// The dummy particles of the solids, made as the engine makes them.
Dummies floor_of(const SimulationSetup& s) {
    Dummies all;
    const double support = 2 * s.h_over_dp * s.dp;
    Box region = s.domain;
    region.min.array() -= support;
    region.max.array() += support;
    for (const BodySetup& body : s.bodies)
        all =
            make_dummies(SurfaceQuery(body.surface), body.surface.bounds(), s.dp, support + s.dp, region, s.dimensions);
    return all;
}

/// Takes one step of the engine, by symplectic Euler or kick-drift-kick, and adds to the budget what the equations at
/// the head say it does. Returns the largest difference of the engine's new velocity from theirs, over the largest
/// change of velocity.
double step_and_account(Simulation& simulation, Budget& budget, const Dummies& floor = {}) {
    const SimulationSetup& s = simulation.setup();
    const double m = simulation.mass(), h = simulation.h(), c0 = s.state_equation.c0, rho0 = s.rho0,
                 dt_before = simulation.dt();
    Particles p = simulation.particles();
    const auto rebuilds = simulation.timers().rebuilds, stops = simulation.ledger().held;
    simulation.step();
    const Particles& next = simulation.particles();
    if (simulation.timers().rebuilds > rebuilds) {
        const double before = sums_of(simulation, p).potential;
        return_from_mirrors(s.mirrors, s.domain, p);
        budget.planes += sums_of(simulation, p).potential - before;
    }
    const bool kick_drift_kick = s.scheme == Scheme::kick_drift_kick;
    const double dt = simulation.dt(), drift = kick_drift_kick ? dt_before / 2 : 0,
                 kick = kick_drift_kick ? (dt_before + dt) / 2 : dt, last_drift = kick_drift_kick ? dt / 2 : dt;
    const std::size_t n = p.size();
    if (next.size() != n) throw std::runtime_error("water left the tank");
    std::vector<std::size_t> place_of_id(n);
    for (std::size_t k = 0; k < n; ++k) place_of_id[static_cast<std::size_t>(next.id[k])] = k;
    auto neighbours = neighbours_of(simulation, p);
    auto wall = wall_of(simulation, p, floor);

    const Kernel kernel(h, 2);
    const double given_back = WaterCompleteness::of_plane_surface(kernel, s.dp, 2);
    std::vector<double> V(n), drho(n), gx(n), gz(n), support_of(n);
    for (std::size_t i = 0; i < n; ++i) V[i] = m / (rho0 + p.drho[i]);
    for (std::size_t i = 0; i < n; ++i) {
        double divergence = 0, support = 0, bx = 0, bz = 0, xx = 0, xz = 0, zz = 0, sx = 0, sz = 0;
        const auto shift = [&](const auto& q, double volume) {
            const double FV = q.F * volume * (1 + 0.2 * std::pow(q.W / kernel.W(s.dp), 4));
            sx += FV * q.x, sz += FV * q.z;
        };
        for (const Neighbour& q : neighbours[i]) {
            const double FV = q.F * V[q.j];
            divergence += FV * ((p.u[i] - q.mirror_x * p.u[q.j]) * q.x + (p.w[i] - q.mirror_z * p.w[q.j]) * q.z);
            support += q.W * V[q.j];
            shift(q, V[q.j]);
            const double jump = double(p.drho[q.j]) + q.higher / (c0 * c0) - p.drho[i];
            bx += FV * jump * q.x, bz += FV * jump * q.z;
            xx += FV * q.x * q.x, xz += FV * q.x * q.z, zz += FV * q.z * q.z;
        }
        const double det = xx * zz - xz * xz;
        gx[i] = det > 0.02 ? (zz * bx - xz * bz) / det : 0;
        gz[i] = det > 0.02 ? (xx * bz - xz * bx) / det : 0;
        double by_wall = 0, touch = 0;  // the solid's normal is upright
        const auto below = [&](double z) { return 2 * std::clamp(0.5 - z / s.dp, 0.0, 1.0); };
        for (const Neighbour& q : neighbours[i]) touch += below(q.z) * q.W * V[q.j];
        for (const WallNeighbour& q : wall[i]) {
            by_wall += q.F * q.volume * p.w[i] * q.z, support += q.W * q.volume;
            shift(q, q.volume);
            touch += below(q.z) * q.W * q.volume;
        }
        support_of[i] = support;
        if (by_wall > 0) by_wall *= std::clamp(1 - (1 - touch) / (1 - s.touch_support), 0.0, 1.0);
        const double rise_by_wall = dt_before * (rho0 + p.drho[i]) * by_wall;
        const double filled = std::clamp((support + given_back * std::hypot(sx, sz) - 0.8) / 0.1, 0.0, 1.0);
        const double waits = support < s.surface_support
                                 ? dt_before * (rho0 + p.drho[i]) * (1 - filled) * std::max(0.0, divergence + by_wall)
                                 : 0;
        drho[i] = p.drho[i] + dt_before * (rho0 + p.drho[i]) * divergence + rise_by_wall - waits;
        if (support < s.surface_support && drho[i] < 0) {
            // its pressure is zero at once: what it held does no work
            budget.tension -= m * elastic_energy(s, p.drho[i]);
            drho[i] = 0;
        } else {
            const double middle = (drho[i] + p.drho[i]) / 2;
            const double per_rise = m * c0 * c0 * middle / std::pow(rho0 + middle, 2);
            budget.solid += per_rise * rise_by_wall;
            budget.voids -= per_rise * waits;
            budget.integrator +=
                m * (elastic_energy(s, drho[i]) - elastic_energy(s, p.drho[i])) - per_rise * (rise_by_wall - waits);
        }
    }
    if (kick_drift_kick) {
        for (std::size_t i = 0; i < n; ++i) {
            p.x[i] += drift * p.u[i], p.z[i] += drift * p.w[i];
            V[i] = m / (rho0 + drho[i]);
        }
        neighbours = neighbours_of(simulation, p);
        wall = wall_of(simulation, p, floor);
    }
    std::vector<double> wall_pressure(floor.places.size()), wall_support(floor.places.size());
    for (std::size_t i = 0; i < n; ++i)
        for (const WallNeighbour& q : wall[i]) {
            const double there = rho0 + drho[i], WV = q.W * V[i];
            wall_pressure[q.d] += WV * (c0 * c0 * drho[i] + there * (s.gravity.x() * q.x + s.gravity.z() * q.z));
            wall_support[q.d] += WV;
        }
    for (std::size_t d = 0; d < floor.places.size(); ++d)
        wall_pressure[d] = wall_support[d] > 0.005 ? wall_pressure[d] / wall_support[d] : 0;
    const double gradient_x = rho0 * s.gravity.x() / (c0 * c0), gradient_z = rho0 * s.gravity.z() / (c0 * c0);
    double difference = 0, largest = 0, support_apart = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double px = 0, pz = 0, vx = 0, vz = 0, hx = 0, hz = 0, diffusion = 0;  // p: exchange, h: of image pressures
        bool at_surface = false;
        for (const Neighbour& q : neighbours[i]) {
            at_surface = at_surface || support_of[q.j] < s.surface_support;
            const double FV = q.F * V[q.j], pressure = c0 * c0 * (drho[i] + drho[q.j]);
            px -= FV * pressure * q.x, pz -= FV * pressure * q.z;
            hx -= FV * q.higher * q.x, hz -= FV * q.higher * q.z;
            const double approach = (p.u[i] - q.mirror_x * p.u[q.j]) * q.x + (p.w[i] - q.mirror_z * p.w[q.j]) * q.z;
            const double viscous = -s.alpha * h * c0 * rho0 * FV * approach / (q.x * q.x + q.z * q.z + 0.01 * h * h);
            vx += viscous * q.x, vz += viscous * q.z;
            const double there_x = gradient_x + q.mirror_x * (gx[q.j] - gradient_x),
                         there_z = gradient_z + q.mirror_z * (gz[q.j] - gradient_z);
            diffusion += FV * (2 * (drho[q.j] + q.higher / (c0 * c0) - drho[i]) - (gx[i] + there_x) * q.x -
                               (gz[i] + there_z) * q.z);
        }
        double sx = 0, sz = 0;  // of the solid
        for (const WallNeighbour& q : wall[i]) {
            const double f = q.F * q.volume * (c0 * c0 * drho[i] + wall_pressure[q.d]);
            sx -= f * q.x, sz -= f * q.z;
        }
        const double ax = V[i] / m * (px + vx + hx + sx) + s.gravity.x(),
                     az = V[i] / m * (pz + vz + hz + sz) + s.gravity.z();
        const double u = p.u[i] + kick * ax / 2, w = p.w[i] + kick * az / 2;  // in the middle of the kick
        budget.viscosity += kick * V[i] * (vx * u + vz * w);
        budget.planes += kick * V[i] * (hx * u + hz * w);
        budget.solid += kick * V[i] * (sx * u + sz * w);
        budget.integrator += kick * V[i] * (px * u + pz * w);
        const double after = drho[i] + kick * s.delta * h * c0 * diffusion;
        budget.diffusion += m * (elastic_energy(s, after) - elastic_energy(s, drho[i]));
        const std::size_t k = place_of_id[static_cast<std::size_t>(p.id[i])];
        if (s.shifting > 0 && !floor.places.empty() && p.z[i] < 2 * h - s.dp / 2 && !at_surface) {
            // of e_i, the difference of S_i from 1, the engine's single precision leaves three digits: taken from there
            const float S = next.shift_support[k].support;
            support_apart = std::max(support_apart, std::abs(double(S) - support_of[i]));
            const double follows = s.packing * c0 / h * rho0 * double(Packing::excess(S, 0));
            budget.packing += m * (elastic_energy(s, after + kick * follows) - elastic_energy(s, after));
        }

        const double un = next.u[k], wn = next.w[k];
        const double shift_x = next.x[k] - p.x[i] - last_drift * un, shift_z = next.z[k] - p.z[i] - last_drift * wn;
        budget.shifting -= m * (s.gravity.x() * shift_x + s.gravity.z() * shift_z);
        budget.shifting_turn += m * (shift_z * un - shift_x * wn);
        // gravity works on the mean velocity of the kick, and the water moves with the old one and the new one
        budget.integrator += m * (s.gravity.x() * (kick * u - drift * p.u[i] - last_drift * un) +
                                  s.gravity.z() * (kick * w - drift * p.w[i] - last_drift * wn));
        if (simulation.ledger().held > stops && next.z[k] < 0.11 * s.dp) {
            const double u_free = p.u[i] + kick * ax, w_free = p.w[i] + kick * az;
            budget.held += m / 2 * (un * un + wn * wn - u_free * u_free - w_free * w_free);
            continue;
        }
        difference = std::max(difference, std::hypot(un - p.u[i] - kick * ax, wn - p.w[i] - kick * az));
        largest = std::max(largest, kick * std::hypot(ax, az));
    }
    EXPECT_LT(support_apart, 2e-6);
    return difference / largest;
}

const char* name_of(Scheme scheme) {
    return scheme == Scheme::kick_drift_kick ? "kick-drift-kick" : "symplectic Euler";
}
constexpr Scheme both[] = {Scheme::symplectic_euler, Scheme::kick_drift_kick};

struct Account {
    Sums start, end;
    Budget budget;
    double largest_difference = 0;  ///< see step_and_account
    int steps_apart = 0;            ///< whose difference is above 1e-3
    double closure() const { return end.energy() - start.energy() - budget.sum(); }
};

Account account_of(Simulation& simulation, double until, const char* name) {
    const Dummies floor = floor_of(simulation.setup());
    Account a;
    a.start = sums_of(simulation, simulation.particles());
    long steps = 0;
    for (; simulation.time() < until; ++steps) {
        const double difference = step_and_account(simulation, a.budget, floor);
        a.largest_difference = std::max(a.largest_difference, difference);
        a.steps_apart += difference > 1e-3;
    }
    a.end = sums_of(simulation, simulation.particles());
    const Budget& b = a.budget;
    const double lost = b.dissipated();
    std::printf("%s, %s: %zu particles, %ld steps\n", name, name_of(simulation.setup().scheme),
                simulation.particles().size(), steps);
    std::printf("  energy [J/m]   kinetic %.4g -> %.4g, potential %.4g -> %.4g, elastic %.3g -> %.3g; change %.5g\n",
                a.start.kinetic, a.end.kinetic, a.start.potential, a.end.potential, a.start.elastic, a.end.elastic,
                a.end.energy() - a.start.energy());
    std::printf(
        "  given by       viscosity %.4g, density diffusion %.4g, no tension %.4g, voids %.4g, held %.3g: dissipated "
        "%.4g\n",
        b.viscosity, b.diffusion, b.tension, b.voids, b.held, lost);
    std::printf(
        "  %% of that      shifting %+.3g, packing %+.3g, mirror planes %+.3g, solid %+.3g, time integrator %+.3g; not "
        "explained %+.2g\n",
        100 * b.shifting / lost, 100 * b.packing / lost, 100 * b.planes / lost, 100 * b.solid / lost,
        100 * b.integrator / lost, 100 * a.closure() / lost);
    std::printf(
        "  velocity after a step differs from the sums' by at most %.1e of the largest change, %d times above 1e-3\n",
        a.largest_difference, a.steps_apart);
    return a;
}

/// A column of water that collapses in a tank between mirror planes.
Simulation column_of(Scheme scheme, double dp, double shifting, double cfl) {
    SimulationSetup s;
    s.scheme = scheme;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = 30;
    s.shifting = shifting;
    s.cfl = cfl;
    s.domain = {Vec3(0, -1, 0), Vec3(1, 1, 3)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    return Simulation(s, fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(0.5, 0, 0.5)}}));
}

void expect_momenta_kept(Scheme scheme, double shifting) {
    Simulation simulation = elliptic_drop(1.0 / 16, 100, 50, shifting, scheme);
    const std::size_t n = simulation.particles().size();
    const double mass = simulation.mass();
    const Sums start = sums_of(simulation, simulation.particles());
    Budget budget;
    while (simulation.time() < 0.0076) step_and_account(simulation, budget);
    const Sums end = sums_of(simulation, simulation.particles());
    const double momentum =
        std::hypot(end.x - start.x, end.z - start.z) / std::sqrt(2 * start.kinetic * mass * static_cast<double>(n));
    const double turn = end.turn / start.turn - 1, by_shifting = budget.shifting_turn / start.turn;
    std::printf(
        "spinning drop, %s, shifting %g: momentum gained %.1e of its scale; angular momentum %+.2e, by shifting "
        "%+.2e\n",
        name_of(scheme), shifting, momentum, turn, by_shifting);
    EXPECT_EQ(simulation.particles().size(), n);
    EXPECT_EQ(simulation.mass(), mass);
    EXPECT_LT(momentum, 1e-6);
    EXPECT_LT(std::abs(turn - by_shifting), 1e-6);  // forces of a pair are equal, opposite and along the pair
    if (shifting > 0)
        EXPECT_LT(std::abs(by_shifting), 0.002);  // found 0.07 %
    else
        EXPECT_LT(std::abs(by_shifting), 1e-12);
}

TEST(Conservation, AFreeDropKeepsMassAndMomenta) {
    for (const Scheme scheme : both)
        for (const double shifting : {0.0, 1.0}) expect_momenta_kept(scheme, shifting);
}

/// What holds in every case: all energy is accounted for, and only dissipated by the terms that should. The integrator
/// of symplectic Euler may give a fifth of that, that of kick-drift-kick gives nothing and takes a tenth at most.
void expect_closed(const Account& a, Scheme scheme) {
    const Budget& b = a.budget;
    EXPECT_LT(std::abs(a.closure()), 1e-5 * b.dissipated());  // found below 1e-6
    // Found 3e-4, single precision; in one step a particle that rounding put on the other side of the free surface's
    // threshold, 0.04.
    EXPECT_LE(a.steps_apart, 2);
    EXPECT_LT(b.viscosity, 0);
    EXPECT_LT(b.diffusion, 0);
    EXPECT_LE(b.tension, 0);
    EXPECT_LE(b.voids, 0);
    EXPECT_LT(a.end.energy(), a.start.energy());
    if (scheme == Scheme::kick_drift_kick) {
        EXPECT_LT(b.integrator, 0);
        EXPECT_GT(b.integrator, -0.1 * b.dissipated());  // found -0.6 to -6 %
    } else {
        EXPECT_LT(std::abs(b.integrator), 0.2 * b.dissipated());  // found +0.2 to +12 %
    }
}

TEST(EnergyBudget, OfAnEllipticDropCloses) {
    for (const Scheme scheme : both)
        for (const double shifting : {1.0, 0.0}) {
            Simulation simulation = elliptic_drop(1.0 / 20, 100, 0, shifting, scheme);
            const Account a =
                account_of(simulation, 0.0076, shifting > 0 ? "elliptic drop" : "elliptic drop, no shifting");
            expect_closed(a, scheme);
            EXPECT_LT(a.budget.dissipated(), 0.025 * a.start.energy());                         // found 1.5 %
            EXPECT_LT(std::abs(a.budget.shifting + a.budget.planes), 1e-9 * a.start.energy());  // no gravity, no walls
        }
}

TEST(EnergyBudget, OfACollapsingColumnClosesAndEulersPartFallsWithTheTimeStep) {
    const auto account = [](Scheme scheme, double shifting, double cfl, const char* name) {
        Simulation simulation = column_of(scheme, 1.0 / 32, shifting, cfl);
        const Account a = account_of(simulation, 1, name);
        expect_closed(a, scheme);
        return a;
    };
    for (const Scheme scheme : both) {
        const Account usual = account(scheme, 1, 0.7, "collapsing column");
        EXPECT_LT(std::abs(usual.budget.shifting), 0.1 * usual.budget.dissipated());  // found +5 %
        EXPECT_LT(std::abs(usual.budget.planes), 0.1 * usual.budget.dissipated());    // found -3 %
        if (scheme == Scheme::kick_drift_kick) continue;
        const Account plain = account(scheme, 0, 0.7, "collapsing column, no shifting");
        const Account halved = account(scheme, 0, 0.35, "collapsing column, no shifting, half the time step");
        EXPECT_LT(std::abs(halved.budget.integrator),
                  0.6 * std::abs(plain.budget.integrator));  // found 0.34: first order
    }
}

TEST(EnergyBudget, OfAColumnThatCollapsesOnASolidFloorCloses) {
    for (const Scheme scheme : both)
        for (const double shifting : {1.0, 0.0}) {
            SimulationSetup s;
            s.scheme = scheme;
            s.dimensions = 2;
            s.dp = 1.0 / 40;
            s.state_equation.c0 = 30;
            s.shifting = shifting;
            s.domain = {Vec3(-2, -1, -0.4), Vec3(2, 1, 1)};
            s.bodies = {prism_along_y({{-3, -0.4}, {3, -0.4}, {3, 0}, {-3, 0}}, 3)};
            Simulation simulation(s, fill_with_fluid(s, {Box{Vec3(-0.25, 0, 0), Vec3(0.25, 0, 0.5)}}));
            const Account a =
                account_of(simulation, 0.5, shifting > 0 ? "on a solid floor" : "on a solid floor, no shifting");
            expect_closed(a, scheme);
            EXPECT_LE(a.budget.held, 0);
            // The floor stands still and yet takes energy: in the continuity its dummy particles stand still, in the
            // momentum their pressure is the water's own, so the two sums are not dual.
            EXPECT_LT(std::abs(a.budget.solid), 0.5 * a.budget.dissipated());  // found -18 %, without shifting -29 %
            // found -4.4 and +1.3 %; none without shifting
            EXPECT_LE(std::abs(a.budget.packing), shifting > 0 ? 0.1 * a.budget.dissipated() : 0);
        }
}

}  // namespace conservation_test
}  // namespace tw
