#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"
#include "structure/generate.h"

namespace tw {
namespace elastic_solid_test {

/// A tank whose floor is a block of soft rubber that can only be compressed: a column of rubber under one of water.
struct ColumnOnRubber {
    static constexpr double width = 0.1, depth = 0.1, height = 0.04, E = 2e5, nu = 0.3, rho = 1100, g = 9.81;
    double dp;

    SimulationSetup setup(int threads = 1) const {
        SimulationSetup s;
        s.dimensions = 2;
        s.dp = dp;
        s.state_equation.c0 = 30;
        const double end = width / 2 + 4 * dp;
        s.domain = {Vec3(-width / 2, -dp / 2, -1.5 * height), Vec3(width / 2, dp / 2, 1.5 * depth)};
        s.mirrors.on = {{{true, true}, {false, false}, {false, false}}};
        s.threads = threads;
        const int along = static_cast<int>(std::lround(2 * end / dp)), up = static_cast<int>(std::lround(height / dp));
        structure::SolidMesh mesh = structure::block_mesh({along, 1, up}, [&](const Vec3& p) {
            return Vec3(end * (2 * p.x() - 1), p.y() - 0.5, height * (p.z() - 1));
        });
        for (const char* face : {"x_min", "x_max", "z_min", "z_max"})
            mesh.surfaces["wet"].insert(mesh.surfaces["wet"].end(), mesh.surfaces[face].begin(),
                                        mesh.surfaces[face].end());
        structure::DegreesOfFreedom dofs(mesh.nodes, 3);
        dofs.clamp(mesh.sets.at("z_min"));
        for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) dofs.hold(std::vector{n}, {0, 1});
        structure::Solid solid(std::move(mesh), {structure::Hyperelastic::saint_venant(E, nu, rho)});
        const Eigen::VectorXd start = Eigen::VectorXd::Zero(solid.dofs());
        ElasticSetup block{
            .structure = ElasticSolid{.solid = std::move(solid), .wet = "wet", .start = start},
            .dofs = std::move(dofs),
            .width = 1,
        };
        block.points = {{"top", Vec3::Zero()}};
        s.bodies.emplace_back(std::make_shared<ElasticSetup>(std::move(block)));
        return s;
    }
    Fluid water(const SimulationSetup& s) const {
        return fill_with_fluid(s, {Box{Vec3(-width / 2, -dp / 2, 0), Vec3(width / 2, dp / 2, depth)}});
    }
    static double modulus() { return E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)); }
    /// Compression of the rubber held on its sides under the water's weight and its own.
    static double exact() { return (1000 * g * depth * height + rho * g * height * height / 2) / modulus(); }
};

const ElasticBody& block_of(const Simulation& run) { return dynamic_cast<const ElasticBody&>(run.body(0)); }

/// Released at rest the water swings on the rubber about the compression at which it would rest; the mean is weighted
/// by a bell over the run, which a swing of many periods leaves alone.
TEST(ElasticSolid, WaterOnRubberCompressesItAsTheFormula) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const ColumnOnRubber column{0.01 / (1 << k)};
        const SimulationSetup s = column.setup();
        Simulation run(s, column.water(s));
        const double T = 0.4;
        double sum = 0, weight = 0, most = 0, upward = 0;
        while (run.time() < T) {
            const double time = run.time();
            run.step();
            const double bell = (run.time() - time) * std::pow(std::sin(std::numbers::pi * time / T), 2);
            const double down = -block_of(run).deflection(0).z();
            sum += bell * down, weight += bell;
            upward -= bell * run.load(0).force.z();
            most = std::max(most, down);
        }
        const double of_weight = upward / weight / (1000 * column.g * column.width * column.depth);
        error[k] = sum / weight / column.exact() - 1;
        std::printf(
            "water on rubber, dp = %.4g m: mean compression %.4g mm, exact %.4g mm (%+.2f %%), most %.4g mm; mean load "
            "%+.2f %% of the weight\n",
            column.dp, 1000 * sum / weight, 1000 * column.exact(), 100 * error[k], 1000 * most, 100 * (of_weight - 1));
        EXPECT_NEAR(of_weight, 1, 0.005);
        EXPECT_GT(most, 1.5 * column.exact()) << "or it does not swing";
    }
    EXPECT_LT(std::abs(error[1]), 0.01);
}

/// As of shells: what the water gives the rubber takes, looked at where it turns back.
TEST(ElasticSolid, InterfaceKeepsMomentumAndEnergy) {
    const ColumnOnRubber column{0.005};
    const SimulationSetup s = column.setup();
    Simulation run(s, column.water(s));
    Vec3 impulse = Vec3::Zero();
    double swing = 0, staggered = 0, before = 0;
    int turns = 0;
    while (run.time() < 0.2) {
        const double time = run.time();
        run.step();
        impulse += (run.time() - time) * run.load(0).force;
        const ElasticBody& block = block_of(run);
        swing = std::max(swing, block.elastic_energy());
        const double speed = block.velocity(block.tie(Vec3::Zero())).z();
        if (before * speed < 0) {
            ++turns;
            staggered = std::max(staggered, std::abs(block.work_given() - block.work_taken()));
        }
        before = speed;
    }
    std::printf(
        "interface of a solid: impulse handed over to %.1e of it; energy of the swing %.4g J, exchanged %.4g J, given "
        "less taken at most %.2g %% of the swing\n",
        (block_of(run).impulse() - impulse).norm() / impulse.norm(), swing, block_of(run).work_exchanged(),
        100 * staggered / swing);
    EXPECT_GE(turns, 4);
    EXPECT_LT((block_of(run).impulse() - impulse).norm(), 1e-6 * impulse.norm());
    EXPECT_LT(staggered, 0.02 * swing);
    EXPECT_LT(staggered, 0.005 * block_of(run).work_exchanged());
}

::testing::AssertionResult same_bits(const Simulation& a, const Simulation& b) {
    const Particles &p = a.particles(), &q = b.particles();
    if (p.x != q.x || p.z != q.z || p.u != q.u || p.w != q.w || p.drho != q.drho)
        return ::testing::AssertionFailure() << "particles differ";
    if (block_of(a).state() != block_of(b).state()) return ::testing::AssertionFailure() << "the solids differ";
    return ::testing::AssertionSuccess();
}

TEST(ElasticSolid, GivesTheSameBitsWithAnyNumberOfThreadsAndAfterARestart) {
    const ColumnOnRubber column{0.01};
    const SimulationSetup s = column.setup();
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "twinwake_elastic_solid_checkpoint.h5";
    Simulation whole(s, column.water(s));
    for (int k = 0; k < 40; ++k) whole.step();
    write_checkpoint(file, "hash", checkpoint_of(whole, 1));
    whole.mark_restart_point();
    Simulation resumed(s, column.water(s));
    restore(resumed, read_checkpoint(file, "hash"));
    std::filesystem::remove(file);
    for (int k = 0; k < 30; ++k) whole.step(), resumed.step();
    EXPECT_TRUE(same_bits(whole, resumed));
    const SimulationSetup two = column.setup(2);
    Simulation one(s, column.water(s)), both(two, column.water(s));
    for (int k = 0; k < 40; ++k) one.step(), both.step();
    EXPECT_TRUE(same_bits(one, both));
}

}  // namespace elastic_solid_test
}  // namespace tw
