#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "base/errors.h"
#include "meshes/generate.h"
#include "sph_solver/air.h"
#include "sph_solver/bench.h"
#include "sph_solver/choose_passes.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/measure/validity_checks.h"
#include "sph_solver/scene_setup.h"
#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"
#include "waves/regular_wave.h"
#include "waves/sea.h"

namespace tw {
namespace engine_test {

/// A closed tank with a column of water against one side.
SimulationSetup tank(int threads = 1) {
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.threads = threads;
    return s;
}
Fluid column(const SimulationSetup& s) { return fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}}); }

/// A stream past a box, with everything that can disturb a restart: inlet, outlet, mirrors, wall.
SimulationSetup stream(int threads = 1) {
    SimulationSetup s;
    s.dp = 0.1;
    s.state_equation.c0 = 40;
    s.domain = {Vec3(-1, 0, -1), Vec3(1.5, 0.8, 2)};
    s.mirrors.on = {{{false, false}, {true, true}, {true, false}}};
    s.stream = Stream{4, 0.02, 0.5};
    s.bodies = {box_surface({Vec3(-0.3, -0.3, -0.2), Vec3(0.3, 0.3, 0.4)})};
    s.threads = threads;
    return s;
}
/// The same with a wave that enters with it.
SimulationSetup stream_with_wave(int threads = 1) {
    SimulationSetup s = stream(threads);
    const RegularWave wave = regular_wave({.height = 0.2, .length = 4, .depth = 1, .closed = false, .stream = 4});
    s.stream->wave = Stream::Wave{in_stream(wave), wave.gravity, 0.02, 0.05};
    return s;
}
/// And with a sum of waves.
SimulationSetup stream_with_sea(int threads = 1) {
    SimulationSetup s = stream(threads);
    const Sea sea = make_sea({.depth = 1, .stream = 4, .height = 0.2, .peak_period = 1.2, .components = 12});
    s.stream->wave = Stream::Wave{sea_in_stream(sea.waves), sea.gravity, 0.02, 0.05};
    return s;
}
Fluid stream_water(const SimulationSetup& s) {
    Box water = s.domain;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer, water.max.z() = 0;
    return fill_with_fluid(s, {water});
}

/// The schemes of a step, with a Courant number at which each is stable, and their evaluations a step.
struct SchemeCase {
    Scheme scheme;
    double cfl;
    int evaluations;
};
constexpr SchemeCase every_scheme[] = {{Scheme::symplectic_euler, 0.7, 1},
                                       {Scheme::kick_drift_kick, 0.7, 1},
                                       {Scheme::predictor_corrector, 0.3, 2},
                                       {Scheme::rk4_frozen_diffusion, 1.4, 4}};
SimulationSetup with(SimulationSetup s, const SchemeCase& c) {
    s.scheme = c.scheme;
    s.cfl = c.cfl;
    return s;
}

::testing::AssertionResult same_bits(const Particles& a, const Particles& b) {
    if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " particles against " << b.size();
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a.id[i] != b.id[i] || a.x[i] != b.x[i] || a.y[i] != b.y[i] || a.z[i] != b.z[i] || a.u[i] != b.u[i] ||
            a.v[i] != b.v[i] || a.w[i] != b.w[i] || a.drho[i] != b.drho[i])
            return ::testing::AssertionFailure() << "particle " << i << " differs";
    return ::testing::AssertionSuccess();
}

TEST(Engine, AnyNumberOfThreadsGivesTheSameBits) {
    for (const SchemeCase& c : every_scheme) {
        const auto run = [&](int threads) {
            Simulation simulation(with(stream(threads), c), stream_water(stream(threads)));
            for (int k = 0; k < 60; ++k) simulation.step();
            return simulation;
        };
        const Simulation one = run(1), three = run(3);
        EXPECT_TRUE(same_bits(one.particles(), three.particles())) << c.evaluations;
        EXPECT_EQ(one.load().force.z(), three.load().force.z());
        EXPECT_NE(one.load().force.z(), 0);
    }
}

TEST(Engine, AWaveThatEntersGoesOnWithTheSameBitsAfterARestartAndWithAnyNumberOfThreads) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "restart_wave_test.h5";
    for (const auto waves : {stream_with_wave, stream_with_sea})
        for (const SchemeCase& c : {every_scheme[1], every_scheme[3]}) {  // of one evaluation, and of stages
            SCOPED_TRACE(c.evaluations);
            const SimulationSetup s = with(waves(1), c);
            Simulation whole(s, stream_water(s)), calm(with(stream(), c), stream_water(s));
            for (int k = 0; k < 20; ++k) whole.step(), calm.step();
            write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
            whole.mark_restart_point();
            Simulation resumed(with(waves(3), c), stream_water(s));
            Checkpoint saved = read_checkpoint(file, "a scene");
            restore(resumed, saved);
            for (int k = 0; k < 20; ++k) whole.step(), resumed.step(), calm.step();
            EXPECT_TRUE(same_bits(whole.particles(), resumed.particles()));
            EXPECT_EQ(whole.ledger().in, resumed.ledger().in);
            EXPECT_FALSE(same_bits(whole.particles(), calm.particles()));
        }
}

TEST(Engine, EachBodyHasItsOwnLoadAndTheirSumIsTheWhole) {
    // water at rest over two boxes of different size on the floor: each bears the weight of the water above it
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1.6, 0.4, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.threads = 1;
    const Surface small = box_surface({Vec3(0.2, -0.2, -0.3), Vec3(0.4, 0.6, 0.2)}),
                  large = box_surface({Vec3(0.8, -0.2, -0.3), Vec3(1.4, 0.6, 0.2)});
    const std::vector<Box> water{{Vec3(0, 0, 0), Vec3(1.6, 0.4, 0.6)}};
    const auto loads = [&](std::vector<BodySetup> bodies) {
        s.bodies = std::move(bodies);
        Simulation simulation(s, fill_with_fluid(s, water));
        for (int k = 0; k < 40; ++k) simulation.step();
        EXPECT_EQ((simulation.load(0).force + simulation.load(1).force - simulation.load().force).norm(), 0);
        return std::pair{simulation.load(0).force, simulation.load(1).force};
    };
    const auto [first, second] = loads({small, large});
    EXPECT_NEAR(second.z() / first.z(), 3, 0.5);  // footprints of 0.6 and 0.2 m; the water still rings
    EXPECT_LT(first.z(), -0.5 * 1000 * 9.81 * 0.4 * 0.2 * 0.4);
    const auto [other, one] = loads({large, small});  // whoever is named first
    EXPECT_NEAR((other - second).norm(), 0, 1e-3 * second.norm());
    EXPECT_NEAR((one - first).norm(), 0, 1e-3 * second.norm());
}

TEST(Engine, ARestartGoesOnWithTheSameBitsInletAndOutletIncluded) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "restart_test.h5";
    for (const SchemeCase& c : every_scheme) {
        SCOPED_TRACE(c.evaluations);
        SimulationSetup s = with(stream(), c);
        s.effects.push_back(Viscosity{1e-3, true, EddyViscosity{}});  // its step limit hangs on the last evaluation
        Simulation whole(s, stream_water(s));
        for (int k = 0; k < 20; ++k) whole.step();
        write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
        whole.mark_restart_point();
        Simulation resumed(s, stream_water(s));
        Checkpoint saved = read_checkpoint(file, "a scene");
        restore(resumed, saved);
        for (int k = 0; k < 20; ++k) whole.step(), resumed.step();
        EXPECT_TRUE(same_bits(whole.particles(), resumed.particles()));
        EXPECT_EQ(whole.time(), resumed.time());
        EXPECT_GT(whole.ledger().in, 0);  // particles did come and go
        EXPECT_EQ(whole.ledger().in, resumed.ledger().in);
        EXPECT_EQ(whole.load().force, resumed.load().force);
    }
    EXPECT_THROW(read_checkpoint(file, "another scene"), InputError);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_THROW(read_checkpoint(file, "a scene"), InputError);
}

TEST(Engine, ARestartWithAirGoesOnWithTheSameBitsAndAnyNumberOfThreads) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "restart_air_test.h5";
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 20;
    s.domain = {Vec3(0, 0, 0), Vec3(0.8, 0.4, 0.8)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, true}}};
    s.threads = 1;
    const std::vector<Box> column{{s.domain.min, Vec3(0.4, 0.4, 0.4)}};  // falls
    const auto make = [&](int threads) {
        s.threads = threads;
        Simulation simulation(s, fill_with_fluid(s, column));
        add_air(simulation, {}, fill_with_air(s, column));
        return simulation;
    };
    Simulation whole = make(1);
    for (int k = 0; k < 60; ++k) whole.step();
    write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
    whole.mark_restart_point();
    Simulation resumed = make(2);
    Checkpoint saved = read_checkpoint(file, "a scene");
    restore(resumed, saved);
    for (int k = 0; k < 60; ++k) whole.step(), resumed.step();
    EXPECT_TRUE(same_bits(whole.particles(), resumed.particles()));
    EXPECT_TRUE(same_bits(whole.gas()->fields().particles(), resumed.gas()->fields().particles()));
    EXPECT_EQ(whole.dt(), resumed.dt());
    EXPECT_GT(whole.gas()->system().extremes.speed, 0);
}

TEST(Engine, AFreeBlobKeepsItsMomentumWhateverItsParticlesDo) {
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 20;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3::Constant(-5), Vec3::Constant(5)};
    s.threads = 1;
    Fluid blob = fill_with_fluid(s, {Box{Vec3::Constant(-0.3), Vec3::Constant(0.3)}});
    for (double& d : blob.depth) d = 0;
    Simulation simulation(s, blob);
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0, 0.3f);
    const FieldsToSet p = simulation.fields_to_set();
    for (std::size_t i = 0; i < p.size(); ++i)
        p.u[i] = 1 + noise(random), p.v[i] = noise(random), p.w[i] = noise(random);
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < p.size(); ++i) sum += simulation.mass() * Vec3(p.u[i], p.v[i], p.w[i]);
        return sum;
    };
    const Vec3 before = momentum();
    for (int k = 0; k < 100; ++k) simulation.step();
    EXPECT_LT((momentum() - before).norm(), 2e-6 * before.norm() * 100);  // rounding of single precision, step by step
}

bool has_only_the_baseline() { return !__builtin_cpu_supports("x86-64-v3"); }
/// Calls `run` once for each variant of the passes that this processor runs.
void with_every_instruction_set(const std::function<void()>& run) {
    const std::string pinned = std::getenv("TWINWAKE_ISA");  // by the tests' main program
    for (const Passes* passes : runnable_passes()) {
        setenv("TWINWAKE_ISA", passes->isa, 1);
        run();
    }
    setenv("TWINWAKE_ISA", pinned.c_str(), 1);
}

TEST(Engine, EveryInstructionSetGivesTheSameForces) {
    if (has_only_the_baseline()) GTEST_SKIP() << "this processor has only the baseline";
    std::vector<double> lifts;
    with_every_instruction_set([&] {
        Simulation simulation(stream(), stream_water(stream()));
        for (int k = 0; k < 5; ++k) simulation.step();
        lifts.push_back(simulation.load().force.z());
    });
    for (double lift : lifts) EXPECT_NEAR(lift, lifts.front(), 1e-4 * std::abs(lifts.front()));
}

TEST(Engine, EveryInstructionSetGivesTheSameEffects) {
    if (has_only_the_baseline()) GTEST_SKIP() << "this processor has only the baseline";
    struct Case {
        const char* name;
        SimulationSetup setup;
        Fluid water;
        EffectOptions effects;
    };
    Case cases[] = {{"viscosity", stream(), stream_water(stream()), {}},
                    {"turbulence", stream(), stream_water(stream()), {}},
                    {"surface tension", tank(), column(tank()), {}}};
    cases[0].effects.push_back(Viscosity{0.5, true, {}});
    cases[1].effects.push_back(Viscosity{1e-3, true, EddyViscosity{5}});
    cases[2].effects.push_back(SurfaceTension{500});
    for (const Case& c : cases) {
        std::vector<double> changes;  // of the velocities, by the effect, summed without regard to sign
        with_every_instruction_set([&] {
            SimulationSetup s = c.setup;
            Simulation without(s, c.water);
            s.effects = c.effects;
            Simulation with(s, c.water);
            for (int k = 0; k < 5; ++k) without.step(), with.step();
            const Particles &a = without.particles(), &b = with.particles();
            changes.push_back(0);
            for (std::size_t i = 0; i < a.size(); ++i)
                changes.back() +=
                    double(std::abs(b.u[i] - a.u[i]) + std::abs(b.v[i] - a.v[i]) + std::abs(b.w[i] - a.w[i]));
        });
        EXPECT_GT(changes.front(), 0.1) << c.name;
        for (const double change : changes) EXPECT_NEAR(change, changes.front(), 0.01 * changes.front()) << c.name;
    }
}

TEST(Engine, EveryInstructionSetGivesTheSameAir) {
    if (has_only_the_baseline()) GTEST_SKIP() << "this processor has only the baseline";
    SimulationSetup s = tank();
    s.mirrors.on[2][1] = true;
    const std::vector<Box> falling{{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}};
    std::vector<double> speeds;  // of the air that the column drives, summed
    with_every_instruction_set([&] {
        Simulation simulation(s, fill_with_fluid(s, falling));
        add_air(simulation, {}, fill_with_air(s, falling));
        while (simulation.time() < 0.05) simulation.step();
        speeds.push_back(0);
        for (const float u : simulation.gas()->fields().particles().u) speeds.back() += double(std::abs(u));
    });
    EXPECT_GT(speeds.front(), 1);
    for (const double speed : speeds) EXPECT_NEAR(speed, speeds.front(), 0.01 * speeds.front());
}

TEST(Engine, ASoundSpeedThatIsTooLowStopsTheRunWithPlaceAndReason) {
    SimulationSetup s = tank();
    s.state_equation.c0 = 0.5;  // the column falls at up to 3 m/s
    Simulation simulation(s, column(s));
    try {
        for (int k = 0; k < 2000; ++k) simulation.step();
        FAIL() << "went on to t = " << simulation.time();
    } catch (const RunError& e) {
        const std::string what = e.what();
        EXPECT_NE(what.find("sound speed"), std::string::npos) << what;
        EXPECT_NE(what.find(" at t = "), std::string::npos) << what;
        EXPECT_NE(what.find("near ("), std::string::npos) << what;
    }
}

TEST(Engine, TheValidityChecksNamesThePlaceOfTheWorst) {
    const SimulationSetup s = tank();
    Simulation simulation(s, column(s));
    RunRecord record;
    while (simulation.time() < 0.02) {
        simulation.step();
        watch_stability(simulation, record);
    }
    std::size_t densest = 0;
    const auto compression = std::ranges::find(record.validity_checks, "compression", &RecordedCheck::name);
    ASSERT_NE(compression, record.validity_checks.end());
    simulation.fields_to_set().drho[29] = 150;  // 15 %: more than is trusted, and than anything the falling column does
    const Vec3 there(simulation.particles().x[29], simulation.particles().y[29], simulation.particles().z[29]);
    simulation.step();
    watch_stability(simulation, record);
    for (std::size_t i = 0; i < simulation.particles().size(); ++i)
        if (simulation.particles().drho[i] > simulation.particles().drho[densest]) densest = i;
    EXPECT_NEAR(compression->value, simulation.particles().drho[densest] / 10, 1e-6);
    EXPECT_LT((compression->place - there).norm(), 2 * s.dp);
    EXPECT_EQ(compression->time, simulation.time());
    for (const RecordedCheck& line : record.validity_checks)
        EXPECT_EQ(line.met(), line.name != "compression") << line.name;
}

TEST(Engine, NotANumberStopsTheRun) {
    const SimulationSetup s = tank();
    Simulation simulation(s, column(s));
    simulation.step();
    simulation.fields_to_set().u[17] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(simulation.step(), RunError);
}

TEST(Bench, MeasuresEveryFigureItPrints) {
    const BenchResult r = run_bench(4000, 1.5, 1, 0.05);
    EXPECT_EQ(r.particles, 16 * 16 * 16);
    EXPECT_NEAR(r.neighbours_per_particle, 113.1, 0.1);
    EXPECT_GT(r.evaluations_per_second, 0);
    EXPECT_GT(r.bytes_per_particle, 100);
    EXPECT_GT(r.share_of_kernel_peak, 0);
    EXPECT_GT(r.share_outside_pairs, 0);
    EXPECT_LT(r.share_outside_pairs, 1);
}

TEST(Engine, NoParticleLeavesAClosedTank) {
    for (const SchemeCase& c : every_scheme) {
        SCOPED_TRACE(c.evaluations);
        const SimulationSetup s = with(tank(), c);
        Simulation simulation(s, column(s));
        const std::size_t n = simulation.particles().size();
        while (simulation.time() < 0.4) simulation.step();
        EXPECT_EQ(simulation.particles().size(), n);
        for (std::size_t i = 0; i < n; ++i) {
            const Particles& p = simulation.particles();
            EXPECT_TRUE(s.domain.contains(Vec3(p.x[i], p.y[i], p.z[i])) || p.x[i] > -s.dp) << i;
        }
    }
}

TEST(Schemes, OfADamBreakAgreeAndEvaluateAsOftenAsTheySay) {
    const auto front = [](const Simulation& simulation) {
        double x = 0;
        for (const double at : simulation.particles().x) x = std::max(x, at);
        return x;
    };
    std::vector<double> fronts;
    for (const SchemeCase& c : every_scheme) {
        const SimulationSetup s = with(tank(), c);
        Simulation simulation(s, column(s));
        const auto n = static_cast<std::int64_t>(simulation.particles().size());
        while (simulation.time() < 0.15) simulation.step();
        EXPECT_EQ(simulation.timers().evaluations, n * simulation.steps() * c.evaluations);
        fronts.push_back(front(simulation));
    }
    EXPECT_GT(fronts.front(), 0.55);  // it has run a spacing and more
    EXPECT_LT(fronts.front(), 0.95);  // and not met the wall
    for (const double x : fronts) EXPECT_NEAR(x, fronts.front(), 0.2 * tank().dp);
}

TEST(Schemes, AreChosenByTheScene) {
    Scene scene;
    scene.domain.dimensions = 3;
    scene.domain.box = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    scene.resolution.near_hull = 0.1;
    scene.water_blocks = {Box{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}};
    scene.sph.c0 = 30;
    EXPECT_EQ(sph_setup(scene, 1).simulation.scheme, SimulationSetup().scheme);
    const std::pair<const char*, Scheme> named[] = {{"symplectic_euler", Scheme::symplectic_euler},
                                                    {"kick_drift_kick", Scheme::kick_drift_kick},
                                                    {"predictor_corrector", Scheme::predictor_corrector},
                                                    {"rk4_frozen_diffusion", Scheme::rk4_frozen_diffusion}};
    for (const auto& [name, scheme] : named) {
        scene.sph.scheme = name;
        EXPECT_EQ(sph_setup(scene, 1).simulation.scheme, scheme) << name;
    }
}

TEST(Schemes, WithOneEvaluationNeedNoMemoryOfStages) {
    std::vector<double> bytes;
    for (const SchemeCase& c : every_scheme) {
        const SimulationSetup s = with(tank(), c);
        Simulation simulation(s, column(s));
        simulation.step();
        bytes.push_back(simulation.bytes());
    }
    EXPECT_EQ(bytes[0], bytes[1]);
    EXPECT_GT(bytes[2], bytes[0]);
    EXPECT_GT(bytes[3], bytes[2]);
}

/// Water in free flight towards the top of the box of `stream()`, without gravity: `count` particles in a row, dp
/// apart.
struct Impact {
    double deepest = 0;                ///< lowest height of any particle above the wall, in spacings
    double momentum = 0, impulse = 0;  ///< lost by the water, got by the wall [N s]
};
Impact throw_at_wall(int count, double speed, const SchemeCase& c) {
    SimulationSetup s = with(stream(), c);
    s.stream.reset();
    s.gravity = Vec3::Zero();
    Fluid drops;
    for (int k = 0; k < count; ++k) {
        drops.places.emplace_back((k % 2) * s.dp - 0.05, ((k / 2) % 2) * s.dp + 0.01, 0.65 + (k / 4) * s.dp);
        drops.depth.push_back(0);
    }
    Simulation simulation(s, drops);
    for (float& w : simulation.fields_to_set().w) w = static_cast<float>(-speed);
    Impact r;
    r.deepest = 1e30;
    const auto momentum = [&] {
        double sum = 0;
        for (float w : simulation.particles().w) sum += simulation.mass() * double(w);
        return sum;
    };
    const double before = momentum();
    while (simulation.time() < 0.6 / speed) {
        const double since = simulation.time();
        simulation.step();
        r.impulse -= simulation.load().force.z() * (simulation.time() - since);
        for (double z : simulation.particles().z) r.deepest = std::min(r.deepest, (z - 0.4) / s.dp);
    }
    r.momentum = momentum() - before;
    return r;
}

TEST(Walls, StopADropAndGetItsMomentum) {
    // A single particle hardly fills its support: pressure stops it late, or the last resort at the wall.
    for (const SchemeCase& c : every_scheme)
        for (const int count : {1, 4, 32}) {
            SCOPED_TRACE(::testing::Message() << c.evaluations << " evaluations, " << count << " particles");
            const Impact r = throw_at_wall(count, 6, c);  // Mach 0.15
            EXPECT_GT(r.deepest, -0.01);
            EXPECT_GT(r.momentum, 0);
            EXPECT_NEAR(r.impulse, r.momentum, 1e-5 * r.momentum);
        }
}

}  // namespace engine_test
}  // namespace tw
