// How long neighbour lists live, and how far they look for it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace list_life_test {

constexpr double dp = 0.05;

/// Weightless water in a closed box, each particle of which flies at random with up to `speed` [m/s].
Simulation agitated(double speed, int threads = 1) {
    SimulationSetup s;
    s.dp = dp;
    s.state_equation.c0 = 30;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3::Zero(), Vec3(0.6, 0.4, 0.6)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, true}}};
    s.threads = threads;
    Fluid fluid = fill_with_fluid(s, {{Vec3::Zero(), Vec3(0.6, 0.4, 0.4)}});
    for (double& depth : fluid.depth) depth = 0;
    Simulation simulation(s, fluid);
    const FieldsToSet p = simulation.fields_to_set();
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    for (std::size_t i = 0; i < p.size(); ++i)
        for (auto* of : {&p.u, &p.v, &p.w}) (*of)[i] = static_cast<float>(speed / std::sqrt(3.0)) * any(random);
    return simulation;
}

/// Pairs of a particle and one that it or an image of it is, which are within the support and not live on the lists.
int missing_pairs(const Level& level) {
    const ParticleSystem& s = level.system();
    const std::vector<PackedPlace>& places = s.particles.place;
    const std::size_t count = s.particles.size() + s.ghosts.count();
    const double support2 = std::pow(0.99999 * s.kernel.support() / s.fixed_point.size, 2);
    const Lists lists = s.near.lists.view();
    int missing = 0;
    for (const Cluster& g : s.near.clusters) {
        std::vector<char> live(count, 0);
        const NeighbourBlock* const first = lists.blocks(g.list);
        for (const NeighbourBlock* b = first; b != first + g.list.size; ++b)
            for (std::size_t bit = 0; bit < 32; ++bit)
                if (b->live >> bit & 1u) live[static_cast<std::size_t>(b->first) + bit] = 1;
        for (std::int32_t i = g.first; i < g.first + g.size; ++i)
            for (std::size_t k = 0; k < count; ++k) {
                const PackedPlace &a = places[static_cast<std::size_t>(i)], &b = places[k];
                const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
                missing += x * x + y * y + z * z < support2 && !live[k];
            }
    }
    return missing;
}

TEST(ListLife, TheSlackFollowsTheRootOfTheApproachWithinItsBounds) {
    const auto over_dp = [](double approach, double passage) {
        return ListLife::slack_for(dp, approach * dp, passage * dp) / dp;
    };
    EXPECT_DOUBLE_EQ(over_dp(0, 0), 0.3);  // still water, and the first step
    EXPECT_DOUBLE_EQ(over_dp(0.001, 0), 0.3);
    EXPECT_NEAR(over_dp(0.16, 0.08), 0.72, 1e-12);
    EXPECT_NEAR(over_dp(0.16, 0.08) / over_dp(0.04, 0.02), 2, 1e-12);
    EXPECT_DOUBLE_EQ(over_dp(1, 0.5), 0.9);
    // a stream that passes a wall by 0.2 dp a step: no lists live longer than three steps
    EXPECT_NEAR(over_dp(0.16, 0.2), 3 * 0.16, 1e-12);
}

TEST(ListLife, FastWaterKeepsItsListsForLongerAndMissesNobodyMeanwhile) {
    for (const double speed : {0.2, 8.0}) {
        Simulation simulation = agitated(speed);
        const ListLife& life = simulation.level(0).system().near.life;
        double widest = 0;
        for (int k = 0; k < 25; ++k) {
            simulation.step();
            ASSERT_EQ(missing_pairs(simulation.level(0)), 0) << speed << " m/s, step " << k;
            widest = std::max(widest, life.slack / dp);
        }
        EXPECT_LT(simulation.timers().rebuilds, 25) << "lists were never kept";
        if (speed < 1)
            EXPECT_DOUBLE_EQ(widest, 0.3);
        else
            EXPECT_GT(widest, 0.45);
    }
}

// The slack says which places stand on a list and so in which order pairs are summed.
TEST(ListLife, ARestartInFastWaterMakesTheListsOfTheRunThatWentOnWithAnyNumberOfThreads) {
    Simulation whole = agitated(8);
    for (int k = 0; k < 15; ++k) whole.step();
    const Checkpoint saved = checkpoint_of(whole, 1);
    whole.mark_restart_point();
    Simulation resumed = agitated(8, 3);
    restore(resumed, saved);
    for (int k = 0; k < 10; ++k) {
        whole.step(), resumed.step();
        ASSERT_EQ(whole.level(0).system().near.life.slack, resumed.level(0).system().near.life.slack) << "step " << k;
    }
    EXPECT_GT(whole.level(0).system().near.life.slack, 0.31 * dp);
    const Particles &a = whole.particles(), &b = resumed.particles();
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.w, b.w);
    EXPECT_EQ(a.drho, b.drho);
}

}  // namespace list_life_test
}  // namespace tw
