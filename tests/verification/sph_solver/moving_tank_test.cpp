// Water in a tank that moves, in the tank's axes, against linear theory and against what holds for any motion.
//
// Linear sloshing of water of depth h in a tank of length L that sways with the acceleration a(t) (Faltinsen & Timokha,
// Sloshing, 2009, sec. 5.4): the surface is sum_n b_n cos k_n (x + L/2), k_n = n pi / L, and for odd n
//
//   b_n'' + w_n^2 b_n = 4 tanh(k_n h) / (n pi) a(t),   w_n^2 = g k_n tanh(k_n h)
//
// (even ones stay zero; a(t) constant gives the slope -a/g). The centre of mass is then at
//
//   x_c = 1/(h L) int x eta dx = - sum_n 2 b_n / (h L k_n^2)
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>

#include "base/numbers.h"
#include "bodies.h"
#include "meshes/generate.h"
#include "sph_solver/air.h"
#include "sph_solver/effects/moving_tank.h"

namespace tw {
namespace moving_tank_test {

constexpr double g = 9.81;

/// Water of depth 0.3 m in a tank of 1 m.
SimulationSetup swaying_tank(double dp, const MovingFrame& frame) {
    SimulationSetup s = tank(dp, 0.5, 0.3, 0.2, 20);
    s.frame = frame;
    s.effects.push_back(MovingTank{});
    return s;
}

/// Of the coarsest level, which is whole everywhere.
Vec3 centre_of_mass(const Simulation& s) {
    Vec3 sum = Vec3::Zero();
    const Particles& p = s.particles();
    for (std::size_t i = 0; i < p.size(); ++i) sum += Vec3(p.x[i], p.y[i], p.z[i]);
    return sum / double(p.size());
}

/// The tank goes 20 mm to the right within 0.6 s and stays.
MovingFrame nudge() {
    MovingFrame f;
    f.law = {.kind = MotionLaw::Kind::table, .axis = Vec3::UnitX(), .times = {0, 0.6}, .values = {0, 0.02}};
    return f;
}

double frequency(int n) {
    const double k = n * pi;
    return std::sqrt(g * k * std::tanh(k * 0.3));
}

/// x_c of linear theory by small steps, up to `end`.
std::vector<double> linear_centre(const MovingFrame& frame, double end, double dt) {
    std::vector<double> x(static_cast<std::size_t>(end / dt) + 2, 0.0);
    for (int n = 1; n <= 9; n += 2) {
        const double k = n * pi, w = frequency(n), by_a = 4 * std::tanh(k * 0.3) / (n * pi);
        double b = 0, rate = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] -= 2 * b / (0.3 * k * k);
            const int parts = 20;
            for (int j = 0; j < parts; ++j) {
                const double t = (double(i) + (j + 0.5) / parts) * dt, h = dt / parts;
                b += h / 2 * rate;
                rate += h * (by_a * frame.law.at(t).acceleration - w * w * b);
                b += h / 2 * rate;
            }
        }
    }
    return x;
}

struct Swung {
    double history = 0;    ///< largest difference of x_c from linear theory's over its largest value
    double frequency = 0;  ///< of the swings after the tank has stopped, over linear theory's
    double early = 0;      ///< the same of the first swing and a half, by how the phase of the fundamental moves
};

/// `fine_from`: particles right of it have the size dp, those left of it twice that; -1: all have dp. `air`: above it.
Swung swing(double dp, double fine_from = -1, bool air = false) {
    SimulationSetup s = swaying_tank(dp, nudge());
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (fine_from > -1) s.zones = {Zone({Box{Vec3(fine_from, -endless, -endless), Vec3::Constant(endless)}})};
    Box below = s.domain;
    below.max.z() = 0;
    Simulation run(s, fill_levels(s, {below}));
    if (air) {
        AirOptions gas;
        gas.sound_speed = 60;
        add_air(run, gas, fill_with_air(s, {below}));
    }
    const double x0 = centre_of_mass(run).x(), end = 4.5, sample = 0.005;
    const std::vector<double> exact = linear_centre(*s.frame, end, sample);
    Swung r;
    double most = 0, before = 0, before_time = 0;
    std::vector<double> crossings;
    // The fundamental in two windows of linear theory's period T, half of it apart: what is off it has no part in them.
    const double w = frequency(1), begin = 0.7;
    std::array<std::complex<double>, 2> fundamental{};
    for (std::size_t i = 1; double(i) * sample < end; ++i) {
        run_to(run, double(i) * sample);
        const double t = run.time(), x = centre_of_mass(run).x() - x0, at = t / sample;
        const auto k = std::min(static_cast<std::size_t>(at), exact.size() - 2);
        const double theory = exact[k] + (at - double(k)) * (exact[k + 1] - exact[k]);
        if (t < 1.5) r.history = std::max(r.history, std::abs(x - theory));
        most = std::max(most, std::abs(theory));
        if (t > 0.7 && before * x < 0) crossings.push_back(before_time + (t - before_time) * before / (before - x));
        for (int n = 0; n < 2; ++n) {
            const double from = std::max(before_time, begin + n * pi / w), to = std::min(t, begin + (n + 2) * pi / w),
                         middle = (before_time + t) / 2;
            if (to > from) fundamental[std::size_t(n)] += (to - from) * (before + x) / 2 * std::polar(1.0, -w * middle);
        }
        before = x, before_time = t;
    }
    r.history /= most;
    r.frequency = pi * double(crossings.size() - 1) / (crossings.back() - crossings.front()) / frequency(1);
    r.early = 1 + std::arg(fundamental[1] / fundamental[0]) / pi;
    return r;
}

TEST(MovingTank, SwingsAsLinearTheorySays) {
    std::printf("dp [m]  frequency - 1 [%%]  centre of mass, up to 1.5 s [%%]  time [s]\n");
    std::vector<Swung> found;
    for (const double dp : {0.025, 0.0125}) {
        const auto start = std::chrono::steady_clock::now();
        found.push_back(swing(dp));
        std::printf("%.3f  %7.2f  %7.2f  %.1f\n", dp, 100 * (found.back().frequency - 1), 100 * found.back().history,
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    // How near the frequency comes is set by the lattice as much as by its spacing, see standing_wave_test.cpp.
    for (const Swung& s : found) EXPECT_LT(std::abs(s.frequency - 1), 0.01);
    EXPECT_LT(found[0].history, 0.07);
    EXPECT_LT(found[1].history, std::min(0.05, found[0].history));
}

/// The force of the frame acts on all sizes of particles, and the edge between them, in the middle of the tank where
/// the water goes to and fro most, lets the swings through. The bound of the history is that of the larger size, and
/// the 5 % of a gravity wave that an edge reflects on its way out of the smaller one (docs/results/levels.md).
TEST(MovingTank, SwingsAsLinearTheorySaysWithTwoSizesOfParticles) {
    const Swung found = swing(0.0125, 0);
    std::printf("two sizes: frequency - 1 %.2f %%, of the first swing and a half %.2f %%, centre of mass %.2f %%\n",
                100 * (found.frequency - 1), 100 * (found.early - 1), 100 * found.history);
    // Judged on the first swing and a half: 1.1 to 1.6 % with six variants of the pair loops. Later ones have half of
    // linear theory's height and another one with each variant: all crossings together give 0.2 to 3.3 %. The bound is
    // the 1 % of one size and half of what the reflected 5 % could do, if they moved the phases of both windows by 0.05
    // apart.
    EXPECT_LT(std::abs(found.early - 1), 0.01 + 0.05 / pi);
    EXPECT_LT(found.history, 0.07 + 0.05);
}

/// Heeled slowly by 5 degrees about a place beside the tank the water stands level in the earth: its centre of mass
/// moves by L^2 tan(5 deg) / (12 h) along the tank's floor.
TEST(MovingTank, ThatHeelsSlowlyKeepsItsSurfaceLevel) {
    MovingFrame frame;
    const double angle = 5 * pi / 180;
    frame.law = {
        .kind = MotionLaw::Kind::table, .turns = true, .axis = Vec3::UnitY(), .times = {0, 3}, .values = {0, angle}};
    frame.pivot = Vec3(0.8, 0, -0.5);
    const SimulationSetup s = swaying_tank(0.02, frame);
    Simulation run(s, water(s));
    run_to(run, 3);
    double mean = 0;  // over the first swing after it
    int count = 0;
    for (; run.time() < 3 + 2 * pi / frequency(1); ++count) {
        mean += centre_of_mass(run).x();
        run_to(run, run.time() + 0.02);
    }
    // turned about y the bow, at -x, goes up: the water runs to +x
    EXPECT_NEAR(mean / count, std::tan(angle) / (12 * 0.3), 0.03 * std::tan(angle) / (12 * 0.3));
}

/// The air goes with its tank: it leaves the swings alone (by its weight they are slower by 0.1 %).
TEST(MovingTank, SwingsAsLinearTheorySaysUnderAir) {
    const Swung found = swing(0.025, -1, true);
    std::printf("under air: frequency - 1 %.2f %%, centre of mass %.2f %%\n", 100 * (found.frequency - 1),
                100 * found.history);
    EXPECT_LT(std::abs(found.frequency - 1), 0.01);
    EXPECT_LT(found.history, 0.07);
}

/// Up and down the water stays as it is and weighs g + a: on the floor, and on a block that stands in it. The motion
/// begins and ends smoothly, so that it makes no sound.
TEST(MovingTank, ThatHeavesMakesItsWaterHeavierAndLighter) {
    MovingFrame frame;
    frame.law = {.kind = MotionLaw::Kind::ramp, .axis = Vec3::UnitZ(), .rate = 2, .ramp = 1};
    SimulationSetup s = swaying_tank(0.02, frame);
    const Surface block =
        section_prism(posed(make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.12}}), {.draft = 0.22}));
    s.bodies.emplace_back(with_span(block, endless_span(block)));
    Simulation run(s, water(s));
    const double most = frame.law.at(0.5).acceleration, volume = 0.2 * 0.12;  // a third of g
    const Vec3 before = centre_of_mass(run);
    PointSamples floor;
    floor.places = {Vec3(-0.35, 0, -0.29)};
    double floor_error = 0, lift_error = 0;
    while (run.time() < 1) {
        const double from = run.time(), at = from + 0.02;
        double lift = 0, exact_lift = 0;
        while (run.time() < at) {
            const double began = run.time();
            run.step();
            const double dt = run.time() - began, heavier = g + frame.law.at(run.time()).acceleration;
            lift += dt * run.load().force.z();
            exact_lift += dt * 1000 * heavier * volume;
        }
        run.sample(floor);
        const double heavier = g + frame.law.at(run.time()).acceleration;
        floor_error = std::max(floor_error, std::abs(double(floor.p[0]) - 1000 * heavier * 0.29));
        lift_error = std::max(lift_error, std::abs(lift - exact_lift) / (run.time() - from));
    }
    std::printf("a is at most %.3g m/s2; largest errors: floor %.3g of rho a h, buoyancy %.3g of rho a V\n", most,
                floor_error / (1000 * most * 0.29), lift_error / (1000 * most * volume));
    EXPECT_LT(floor_error, 0.1 * 1000 * most * 0.29);
    EXPECT_LT(lift_error, 0.25 * 1000 * most * volume);
    EXPECT_LT((centre_of_mass(run) - before).norm(), 0.001);
}

/// Water whose pressure balances gravity and a tank's acceleration of 3 m/s2 rests, at the walls as elsewhere.
TEST(MovingTank, LeavesWaterInBalanceAloneAtItsWalls) {
    const double w = 2 * pi, across = 3;
    MovingFrame frame;
    frame.law = {.kind = MotionLaw::Kind::sinusoid,
                 .axis = Vec3::UnitX(),
                 .amplitude = across / (w * w),
                 .period = 1,
                 .phase = pi / 2};  // at the start the tank is accelerated to -x
    SimulationSetup s = swaying_tank(0.02, frame);
    s.state_equation.c0 = 200;  // so that the water is nearly as dense below as above
    Simulation run(s, water(s));
    const FieldsToSet p = run.fields_to_set();
    const double c2 = s.state_equation.c0 * s.state_equation.c0;
    for (std::size_t i = 0; i < p.size(); ++i)
        p.drho[i] = static_cast<float>(1000 / c2 * (across * (p.x[i] + 0.5) - g * p.z[i]));
    run.step();
    double most = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (p.z[i] < -0.12)  // clear of the surface, where this pressure is not zero
            most = std::max(most, std::hypot(double(p.u[i]), double(p.w[i])) / run.time());
    std::printf("largest acceleration %.3g m/s2\n", most);
    EXPECT_LT(most, 0.03 * across);
}

TEST(MovingTank, GivesTheSameBitsWithAnyNumberOfThreads) {
    MovingFrame frame;
    frame.law = {.kind = MotionLaw::Kind::sinusoid,
                 .turns = true,
                 .axis = Vec3::UnitY(),
                 .amplitude = 0.2,
                 .period = 1,
                 .phase = pi / 2};
    const auto end = [&](int threads) {
        SimulationSetup s = swaying_tank(0.03, frame);
        s.threads = threads;
        Simulation run(s, water(s));
        run_to(run, 0.3);
        return run.particles().x;
    };
    const auto one = end(1);
    EXPECT_EQ(one, end(2));
    EXPECT_EQ(one, end(3));
}

/// A box afloat in a tank that is moved up and down weighs as much more as the water does: it keeps its draft, and the
/// water bears m (g + a).
TEST(MovingTank, ThatHeavesLeavesABodyAfloatAtItsDraft) {
    MovingFrame frame;
    frame.law = {.kind = MotionLaw::Kind::ramp, .axis = Vec3::UnitZ(), .rate = 2, .ramp = 1};
    SimulationSetup s = swaying_tank(0.02, frame);
    s.bodies = {box_body(0.3, 0.2, 0.1, 500)};
    Simulation run(s, water(s));
    const double mass = rigid_of(run.body(0)).mass().mass;
    double rise = 0, lift = 0, weight = 0;
    while (run.time() < 0.6) {
        const double began = run.time();
        run.step();
        rise = std::max(rise, std::abs(centre_of(run).z()));
        lift += (run.time() - began) * run.load(0).force.z();
        weight += (run.time() - began) * mass * (g + frame.law.at(run.time()).acceleration);
    }
    std::printf("afloat in a tank that heaves: moves by %.2g m, is borne by %.4f of its weight\n", rise, lift / weight);
    EXPECT_LT(rise, 0.01 * 0.1);
    EXPECT_NEAR(lift / weight, 1, 0.01);
    EXPECT_GT(weight / (mass * g * run.time()), 1.2);
}

/// In a full tank that sways the water goes with it, and so does a body as dense as water. One of half that density
/// runs ahead by (1 - 1/2) / (1/2 + C) of the way, C the added mass over that of the water in its place: 1.19 of a
/// square in open water, where that is 0.3, and more between walls.
TEST(MovingTank, CarriesABodyAsDenseAsItsWater) {
    const auto way = [](double density) {
        SimulationSetup s = tank(0.02, 0.3, 0.4, 0, 20);
        s.mirrors.on[2] = {true, true};
        s.frame = MovingFrame{};
        s.frame->law = {.kind = MotionLaw::Kind::ramp, .axis = Vec3::UnitX(), .rate = 0.5, .ramp = 0.5};
        s.effects.push_back(MovingTank{});
        s.bodies = {box_body(0.16, 0.16, 0.28, density)};
        Simulation run(s, water(s));
        const double start = centre_of(run).x();
        run_to(run, 0.3);
        return (centre_of(run).x() - start) / s.frame->law.at(0.3).path;
    };
    const double as_dense = way(1000), lighter = way(500);
    std::printf("in a tank that sways, of the tank's way: as dense as water %.3f, half as dense %.3f\n", as_dense,
                lighter);
    EXPECT_LT(std::abs(as_dense), 0.02);
    EXPECT_GT(lighter, 0.1);
    EXPECT_LT(lighter, 0.3);
}

/// Heeled slowly, a box afloat stays level in the earth.
TEST(MovingTank, ThatHeelsSlowlyKeepsABodyAfloatLevel) {
    MovingFrame frame;
    const double angle = 5 * pi / 180;
    frame.law = {
        .kind = MotionLaw::Kind::table, .turns = true, .axis = Vec3::UnitY(), .times = {0, 2}, .values = {0, angle}};
    SimulationSetup s = swaying_tank(0.02, frame);
    s.bodies = {box_body(0.3, 0.12, 0.06, 500)};
    Simulation run(s, water(s));
    run_to(run, 2);
    double mean = 0, time = 0;
    while (run.time() < 2 + 2 * pi / frequency(1)) {
        const double began = run.time();
        run.step();
        const Eigen::Quaterniond& q = rigid_of(run.body(0)).state().attitude;
        mean += (run.time() - began) * 2 * std::atan2(q.y(), q.w()), time += run.time() - began;
    }
    std::printf("heeled by %.3f rad, a box afloat in it by %.3f rad\n", angle, mean / time);
    EXPECT_NEAR(mean / time, -angle, 0.1 * angle);
}

}  // namespace moving_tank_test
}  // namespace tw
