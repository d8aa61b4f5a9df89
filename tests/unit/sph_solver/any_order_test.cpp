// Sums over particles do not depend on the order in which particles are kept: loads, impulses, momentum and energies
// have the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "meshes/generate.h"
#include "sph_solver/air.h"
#include "sph_solver/bodies/cluster_loads.h"
#include "sph_solver/bodies/rigid_in_water.h"
#include "sph_solver/effects/moving_tank.h"
#include "sph_solver/measure/tank_balance.h"
#include "sph_solver/measure/water_energy.h"
#include "sph_solver/simulation.h"
#include "system_to_change.h"

namespace tw {
namespace any_order_test {

constexpr double dp = 0.05;

std::vector<std::int32_t> shuffled(std::size_t n) {
    std::vector<std::int32_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::shuffle(order, std::mt19937(11));
    return order;
}

/// Water 0.6 m deep in a tank, over a box that stands on the floor.
SimulationSetup tank_with_a_box() {
    SimulationSetup s;
    s.dp = dp;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1.6, 0.6, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.bodies = {box_surface({Vec3(0.4, -0.2, -0.3), Vec3(1.2, 0.8, 0.2)})};
    s.threads = 1;
    return s;
}
Fluid water_of(const SimulationSetup& s) {
    return fill_with_fluid(s, {Box{s.domain.min, Vec3(s.domain.max.x(), s.domain.max.y(), 0.6)}});
}
/// Velocities of which each particle has its own, by its name.
void stir(Particles& p, double downwards = 0) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        std::mt19937 random(static_cast<unsigned>(p.id[i]));
        std::uniform_real_distribution<float> any(-1, 1);
        p.u[i] = any(random), p.v[i] = any(random), p.w[i] = any(random) - static_cast<float>(downwards);
        p.drho[i] = 5 * any(random);
    }
}
double plain_sum(const std::vector<float>& values) {
    double sum = 0;
    for (const float v : values) sum += double(v) * v;
    return sum;
}

TEST(AnyOrder, OfEnergyAndOfMomentumInAVolume) {
    const SimulationSetup s = tank_with_a_box();
    Simulation simulation(s, water_of(s));
    const ControlVolume volume({Vec3(0.22, 0, 0), Vec3(1.4, 0.61, 0.43)}, dp, {});
    Particles& p = system_to_change(simulation.level(0)).particles;
    stir(p);
    const auto measure = [&] {
        const WaterEnergy e = water_energy(simulation);
        using Inside = ControlVolume::Inside;
        const Inside inside = simulation.level(0).fields().sum_over_all<Inside>(
            [&](Inside& sum, std::size_t i) { volume.add_inside(p, i, sum); });
        const Vec3 momentum = inside.momentum.value();
        const double mass = inside.share.value();
        return std::vector{e.mass,        e.kinetic,    e.potential,
                           e.elastic,     momentum.x(), momentum.y(),
                           momentum.z(),  mass,         gas_energy(simulation.level(0), s.gravity),
                           plain_sum(p.u)};
    };
    std::vector<double> before = measure();
    double kinetic = 0;
    for (std::size_t i = 0; i < p.size(); ++i) kinetic += Vec3(p.u[i], p.v[i], p.w[i]).squaredNorm();
    EXPECT_NEAR(before[1], simulation.mass() / 2 * kinetic, 1e-12 * before[1]);
    p.reorder(shuffled(p.size()));
    std::vector<double> after = measure();
    EXPECT_NE(before.back(), after.back());  // or the order is no test
    before.pop_back(), after.pop_back();
    EXPECT_EQ(before, after);
}

TEST(AnyOrder, OfWhatATankThatMovesDoes) {
    SimulationSetup s = tank_with_a_box();
    s.bodies.clear();
    s.frame.emplace();
    s.frame->law = {.kind = MotionLaw::Kind::table, .axis = Vec3::UnitX(), .times = {0, 0.6}, .values = {0, 0.2}};
    s.effects.push_back(MovingTank{});
    const auto row_of = [&](bool reordered) {
        Simulation simulation(s, water_of(s));
        Particles& p = system_to_change(simulation.level(0)).particles;
        stir(p);
        const auto reorder = [&] {
            if (reordered) p.reorder(shuffled(p.size()));
        };
        simulation.step();
        simulation.mark_restart_point();  // who is whose neighbour is found anew, in both
        TankBalance balance;
        reorder();
        balance.begin(simulation);
        simulation.step();
        reorder();
        balance.after_step(simulation);
        Table tank;
        balance.record(simulation, tank, "N", "J");
        std::vector<double> row;
        for (const Column& c : tank.columns) row.push_back(c.values.back());
        return row;
    };
    const std::vector<double> row = row_of(false);
    EXPECT_EQ(row.size(), 4u);
    EXPECT_NE(row.front(), 0);
    EXPECT_EQ(row, row_of(true));
}

TEST(AnyOrder, OfTheClustersThatLoadBodies) {
    constexpr int count = 500, bodies = 3;
    std::mt19937 random(5);
    std::normal_distribution<float> any(0, 100);
    std::vector<std::vector<WallLoad>> of_cluster(count);  // every fifth cluster has no wall near
    for (int n = 0; n < count; ++n)
        for (int b = 0; b < n % 5 && b < bodies; ++b)
            of_cluster[static_cast<std::size_t>(n)].push_back(
                {any(random), any(random), any(random), any(random), any(random), any(random), b});
    const auto loads_in = [&](const std::vector<std::int32_t>& order) {
        std::vector<Cluster> clusters;
        std::vector<WallLoad> loads;
        for (const std::int32_t n : order) {
            const auto& own = of_cluster[static_cast<std::size_t>(n)];
            Cluster& g = clusters.emplace_back();
            g.first = n;
            if (!own.empty()) g.wall_load = static_cast<std::int32_t>(loads.size());
            loads.insert(loads.end(), own.begin(), own.end());
        }
        std::vector<PushSum> sums(bodies);
        add_cluster_loads(
            clusters, loads, [](const Cluster& g) { return Vec3(0.1 * g.first, 0.3, -1.0 / (1 + g.first)); }, sums);
        std::vector<double> values;
        for (const PushSum& sum : sums)
            for (const Vec3& v : {sum.push.value(), sum.turn.value()}) values.insert(values.end(), v.begin(), v.end());
        return values;
    };
    std::vector<std::int32_t> in_order(count);
    std::iota(in_order.begin(), in_order.end(), 0);
    const std::vector<double> loads = loads_in(in_order);
    double expected = 0;
    for (const auto& own : of_cluster)
        for (const WallLoad& w : own) expected += w.body == 1 ? double(w.ay) : 0;
    EXPECT_NEAR(loads[6 + 1], expected, 1e-9);
    EXPECT_EQ(loads, loads_in(shuffled(count)));
}

/// What a level's last act gives, with the particles as they are or in another order.
std::vector<double> advanced(bool reordered) {
    const SimulationSetup s = tank_with_a_box();
    Simulation simulation(s, water_of(s));
    simulation.set_control_volume(ControlVolume({Vec3(0.22, 0, 0), Vec3(1.4, 0.61, 0.43)}, dp, {}));
    Level& level = simulation.level(0);
    Particles& p = system_to_change(level).particles;
    level.refresh(0);
    level.first_pair_loop(0, 0, 0, nullptr);
    level.second_pair_loop(0);
    level.loads().gather(Vec3::Zero());
    stir(p, 6);  // onto the box, so fast that nothing but the last resort keeps them out
    if (reordered) {
        std::vector<std::int32_t> order = shuffled(p.size());
        std::vector<std::int32_t> and_images = order;
        for (std::size_t i = p.size(); i < p.place.size(); ++i) and_images.push_back(static_cast<std::int32_t>(i));
        p.each([&](AnyField& f) {
            if (p.has(f.with()) && &f != &p.surface) f.take(f.in_images() ? and_images : order);
        });
    }
    const double dt = 0.6 * dp / 6;
    const Level::Impulses impulses = level.advance({dt, 0, dt}, Vec3(0.3, 0.1, 0.2));
    EXPECT_GT(level.system().ledger.held, 100);
    std::vector<double> all;
    const Load& load = level.system().walls.loads().front();
    for (const Vec3& v : {impulses.bodies.front().impulse, impulses.bodies.front().turn, load.force, load.moment,
                          level.control_volume()->state().crossed})
        all.insert(all.end(), v.begin(), v.end());
    return all;
}

TEST(AnyOrder, OfParticlesHeldAtWallsAndCrossingFaces) {
    const std::vector<double> kept = advanced(false);
    EXPECT_LT(kept[2], 0);      // an impulse downwards
    EXPECT_NE(kept.back(), 0);  // and momentum through the volume's faces
    EXPECT_EQ(kept, advanced(true));
}

// Who is whose neighbour is a function of the places alone, so the whole run has the same bits.
TEST(AnyOrder, AtTheStartAndAnyNumberOfThreadsFloatABodyAlike) {
    SimulationSetup s = tank_with_a_box();
    s.bodies = {BodySetup(box_surface({Vec3(0.6, 0.2, 0.45), Vec3(1, 0.4, 0.7)}))};
    s.bodies.front().moving = RigidBodySetup{};
    s.bodies.front().moving->mass = solid_mass(s.bodies.front().surface, 600);
    s.bodies.front().moving->free = {{true, true, true}, {true, true, true}};
    const auto run = [&](bool reordered, int threads) {
        s.threads = threads;
        Fluid fluid = water_of(s);
        const Fluid kept = fluid;
        const std::vector<std::int32_t> order = shuffled(fluid.places.size());
        for (std::size_t k = 0; k < order.size() && reordered; ++k) {
            fluid.places[k] = kept.places[static_cast<std::size_t>(order[k])];
            fluid.depth[k] = kept.depth[static_cast<std::size_t>(order[k])];
        }
        Simulation simulation(s, fluid);
        Particles& p = system_to_change(simulation.level(0)).particles;
        std::vector<double> all;
        for (int k = 0; k < 40; ++k) {
            if (k == 20) simulation.mark_restart_point();
            if (k == 20 && reordered) p.reorder(shuffled(p.size()));
            simulation.step();
            const Load load = simulation.load();
            for (const Vec3& v : {load.force, load.moment, rigid_of(simulation.body(0)).state().centre})
                all.insert(all.end(), v.begin(), v.end());
            const WaterEnergy e = water_energy(simulation);
            all.insert(all.end(), {e.kinetic, e.potential, e.elastic});
        }
        return all;
    };
    EXPECT_EQ(run(false, 1), run(true, 2));
}

}  // namespace any_order_test
}  // namespace tw
