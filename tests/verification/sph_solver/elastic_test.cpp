#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>
#include <vector>

#include "base/errors.h"
#include "column_on_plate.h"
#include "sph_solver/air.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace elastic_test {

/// Released at rest the plate swings about the deflection at which the water would rest on it. The mean is weighted by
/// a bell over the run, which a swing of many periods leaves alone.
TEST(Elastic, WaterOnAPlateBendsItAsTheFormula) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const ColumnOnPlate column{0.01 / (1 << k)};
        const SimulationSetup s = column.setup();
        Simulation run(s, column.water(s));
        const double T = 0.4;
        double sum = 0, weight = 0, most = 0, upward = 0;
        while (run.time() < T) {
            const double time = run.time();
            run.step();
            const double bell = (run.time() - time) * std::pow(std::sin(std::numbers::pi * time / T), 2);
            const double w = plate_of(run).deflection(0).z();
            sum += bell * w, weight += bell;
            upward += bell * run.load(0).force.z();
            most = std::max(most, -w);
        }
        const double of_weight = -upward / weight / (1000 * column.g * column.span * column.depth);
        error[k] = -sum / weight / column.exact() - 1;
        std::printf(
            "water on a plate, dp = %.4g m: mean deflection %.4g mm, exact %.4g mm (%+.2f %%), most %.4g mm; mean load "
            "%+.2f %% of the weight\n",
            column.dp, -1000 * sum / weight, 1000 * column.exact(), 100 * error[k], 1000 * most, 100 * (of_weight - 1));
        EXPECT_NEAR(of_weight, 1, 0.005);
        EXPECT_GT(most, 1.5 * column.exact()) << "or it does not swing";
    }
    EXPECT_LT(std::abs(error[1]), 0.01);
    EXPECT_LT(std::abs(error[1]), 0.6 * std::abs(error[0]));
}

/// The plate's mean deflection over that of the formula, and the water's mean load on it over its weight.
struct Borne {
    double deflection, load;
};
Borne borne_by_plate(Simulation& run) {
    const double T = 0.4;
    double sum = 0, weight = 0, upward = 0;
    while (run.time() < T) {
        const double time = run.time();
        run.step();
        const double bell = (run.time() - time) * std::pow(std::sin(std::numbers::pi * time / T), 2);
        sum += bell * plate_of(run).deflection(0).z(), weight += bell;
        upward += bell * run.load(0).force.z();
    }
    const ColumnOnPlate of{};
    return {-sum / weight / of.exact(), -upward / weight / (1000 * of.g * of.span * of.depth)};
}

/// The lower half of the column is of particles half as large.
TEST(Elastic, WaterOfTwoSizesBendsAPlateAsThatOfOneDoes) {
    const ColumnOnPlate column{0.005};
    SimulationSetup s = column.setup();
    constexpr double endless = std::numeric_limits<double>::infinity();
    s.zones = {Zone({Box{Vec3(-endless, -endless, -endless), Vec3(endless, endless, 0.1)}})};
    const Box water{Vec3(-column.span / 2, -column.dp / 2, 0), Vec3(column.span / 2, column.dp / 2, column.depth)};
    Simulation run(s, fill_levels(s, {water}));
    const Borne found = borne_by_plate(run);
    std::printf("water of two sizes on a plate: deflection %.4f of the exact one, load %.4f of the weight\n",
                found.deflection, found.load);
    EXPECT_NEAR(found.load, 1, 0.01);
    EXPECT_NEAR(found.deflection, 1, 0.015);
    EXPECT_LT(run.level(0).fields().particles().size() + run.level(1).fields().particles().size(), 1700u)
        << "or all are small";
    EXPECT_LT(std::abs(run.refinements()[0].mass_drift()), 0.01);
}

/// Air shut in under the plate is a spring: where the plate bends by w W(x) it loses that volume, and bears
///
///   K w mean(W) / H,   K = rho_a c_a^2,   mean(W) = 8/15 between clamps,
///
/// and at the start, at the pressure of its depth, its own weight from the water's surface on.
TEST(Elastic, AirShutInUnderAPlateBearsItAsASpring) {
    const ColumnOnPlate column{0.01};
    SimulationSetup s = column.setup();
    const double skin = 6 * column.dp, height = 0.1;
    s.domain.min.z() = -skin - height;
    s.mirrors.on[2] = {true, false};
    const Box water{Vec3(-column.span / 2, -column.dp / 2, 0), Vec3(column.span / 2, column.dp / 2, column.depth)};
    Fluid below = fill_with_air(s, {water});
    std::erase_if(below.depth, [&](double depth) { return depth < column.depth; });
    std::erase_if(below.places, [](const Vec3& x) { return x.z() > 0; });
    AirOptions air;
    air.density = 10;
    air.sound_speed = 60;
    Simulation run(s, column.water(s));
    add_air(run, air, below);
    const Borne found = borne_by_plate(run);
    const double K = air.density * air.sound_speed * air.sound_speed, q = 1000 * column.g * column.depth,
                 own = column.rho * column.g * column.thickness, w = column.exact();
    const double of_air = air.density * column.g * (column.depth + skin);
    const double exact = (q + own - of_air) / (q + own + K * w * 8. / 15 / height);
    std::printf("a plate between water and air: deflection %.4f of that without air, %.4f by the formula\n",
                found.deflection, exact);
    EXPECT_LT(exact, 0.92) << "or the air does nothing";
    EXPECT_NEAR(found.deflection / exact, 1, 0.03);
    EXPECT_EQ(run.ledger().lost, 0);
}

TEST(Elastic, NeedsTheSchemeWhoseDriftItMeetsInTheMiddle) {
    const ColumnOnPlate column{0.02};
    SimulationSetup s = column.setup();
    for (const Scheme scheme : {Scheme::symplectic_euler, Scheme::predictor_corrector}) {
        s.scheme = scheme;
        EXPECT_THROW(Simulation(s, column.water(s)), InputError);
    }
}

/// By penalty contact it rests on forces between particles and surface alone; how stiff they are moves where it rests,
/// not how heavy it is.
TEST(Elastic, APenaltyContactBearsTheWaterWhateverItsStiffness) {
    const ColumnOnPlate column{0.01};
    using Law = PenaltyContact::Law;
    for (const Law law : {Law::linear, Law::nonlinear, Law::adaptive})
        for (const double factor : {1e-4, 1e-3}) {
            SimulationSetup s = column.setup();
            auto setup = std::make_shared<ElasticSetup>(*s.bodies[0].elastic);
            setup->coupling.interface = penalty_interface({.law = law, .factor = factor});
            s.bodies[0] = BodySetup(setup);
            Simulation run(s, column.water(s));
            const Borne found = borne_by_plate(run);
            std::printf("penalty law %d, factor %.0e: load %.4f of the weight, deflection %.4f of the exact one\n",
                        static_cast<int>(law), factor, found.load, found.deflection);
            EXPECT_NEAR(found.load, 1, 0.02);
            EXPECT_NEAR(found.deflection, 1, 0.05);
            EXPECT_EQ(run.ledger().lost, 0);
        }
}

/// Work that the water gives is work that the plate takes. Looked at where the plate turns back: there the half step by
/// which the water's density lags does not matter. Without artificial viscosity, diffusion and shifting the energy of
/// water and plate together is nearly kept too; what is missing the water's own walls lose.
TEST(Elastic, InterfaceKeepsMomentumAndEnergy) {
    const ColumnOnPlate column{0.005};
    SimulationSetup s = column.setup();
    s.alpha = s.delta = s.shifting = 0;
    Simulation run(s, column.water(s));
    const double c0 = s.state_equation.c0;
    const auto energy = [&] {
        const Particles& p = run.particles();
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double u2 = double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i];
            sum += run.mass() * (u2 / 2 + column.g * p.z[i] + c0 * c0 * p.drho[i] * p.drho[i] / 2e6);
        }
        const structure::ShellMesh& mesh = plate_of(run).setup().shell().shell.mesh();
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
            sum += column.g * plate_of(run).setup().shell().shell.mass()[static_cast<Eigen::Index>(6 * n)] *
                   plate_of(run).place(plate_of(run).tie(mesh.nodes[n])).z();
        return sum + plate_of(run).kinetic_energy() + plate_of(run).elastic_energy();
    };
    const double start = energy();
    Vec3 impulse = Vec3::Zero();
    double most = 0, swing = 0, staggered = 0, before = 0;
    int turns = 0;
    while (run.time() < 0.12) {
        const double time = run.time();
        run.step();
        impulse += (run.time() - time) * run.load(0).force;
        swing = std::max(swing, plate_of(run).elastic_energy());
        const ElasticBody& plate = plate_of(run);
        const double speed = plate.velocity(plate.tie(Vec3(0, 0, -3 * column.dp))).z();
        if (before * speed < 0) {
            ++turns;
            most = std::max(most, std::abs(energy() - start));
            staggered = std::max(staggered, std::abs(plate.work_given() - plate.work_taken()));
        }
        before = speed;
    }
    std::printf(
        "interface: impulse handed over to %.1e of it; energy of the swing %.4g J, off by %.2g %%; exchanged %.4g J, "
        "given less taken at most %.2g %% of the swing\n",
        (plate_of(run).impulse() - impulse).norm() / impulse.norm(), swing, 100 * most / swing,
        plate_of(run).work_exchanged(), 100 * staggered / swing);
    EXPECT_GE(turns, 4);
    EXPECT_LT((plate_of(run).impulse() - impulse).norm(), 1e-6 * impulse.norm());
    EXPECT_LT(staggered, 0.01 * swing);
    EXPECT_LT(most, 0.05 * swing);
}

::testing::AssertionResult same_bits(const Simulation& a, const Simulation& b) {
    const Particles &p = a.particles(), &q = b.particles();
    if (p.x != q.x || p.z != q.z || p.u != q.u || p.w != q.w || p.drho != q.drho)
        return ::testing::AssertionFailure() << "particles differ";
    if (plate_of(a).state() != plate_of(b).state()) return ::testing::AssertionFailure() << "the plates differ";
    return ::testing::AssertionSuccess();
}

TEST(Elastic, PlatesGiveTheSameBitsWithAnyNumberOfThreadsAndAfterARestart) {
    const ColumnOnPlate column{0.01};
    for (const bool large_rotations : {false, true}) {
        const SimulationSetup s = column.setup(1, large_rotations);
        const std::filesystem::path file = std::filesystem::temp_directory_path() / "twinwake_elastic_checkpoint.h5";
        Simulation whole(s, column.water(s));
        for (int k = 0; k < 40; ++k) whole.step();
        write_checkpoint(file, "hash", checkpoint_of(whole, 1));
        whole.mark_restart_point();
        Simulation resumed(s, column.water(s));
        restore(resumed, read_checkpoint(file, "hash"));
        for (int k = 0; k < 30; ++k) whole.step(), resumed.step();
        EXPECT_TRUE(same_bits(whole, resumed));
        SimulationSetup fixed = s;
        fixed.bodies[0].elastic.reset();
        Simulation other(fixed, column.water(s));
        EXPECT_THROW(restore(other, read_checkpoint(file, "hash")), InputError);
        std::filesystem::remove(file);
        SimulationSetup two = column.setup(2, large_rotations);
        Simulation one(s, column.water(s)), both(two, column.water(s));
        for (int k = 0; k < 40; ++k) one.step(), both.step();
        EXPECT_TRUE(same_bits(one, both));
    }
}

TEST(Elastic, BodiesNeedKickDriftKick) {
    const ColumnOnPlate column{0.01};
    SimulationSetup s = column.setup();
    const Fluid water = column.water(s);
    s.scheme = Scheme::symplectic_euler;
    EXPECT_THROW(Simulation(s, water), InputError);
}

}  // namespace elastic_test
}  // namespace tw
