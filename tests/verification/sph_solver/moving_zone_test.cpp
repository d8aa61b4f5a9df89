// Zones of finer particles that move: through water at rest nothing is to move, and round a body that enters water the
// motion is to be that of particles of one size.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "base/errors.h"
#include "base/numbers.h"
#include "bodies.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace moving_zone_test {

Simulation filled(const SimulationSetup& s) {
    Box below = s.domain;
    below.max.z() = 0;
    return Simulation(s, fill_levels(s, {below}));
}

struct Stirred {
    double rms = 0;      ///< velocity of the fine particles over sqrt(g H), in the second half
    double fastest = 0;  ///< particle of any size at any time, over sqrt(g H)
    double surplus = 0;  ///< of the zone's mass
    std::int64_t splits = 0, orphans = 0;
};

/// 1.6 s of still water, 0.8 m deep, with a box of finer particles 0.2 m below its surface and above its floor that
/// goes 0.8 m to the side at 0.5 m/s.
Stirred still_water() {
    const double dp = 0.01, depth = 0.8, way = 0.8, speed = 0.5;
    SimulationSetup s = tank(dp, 0.8, depth, 0.2, 10 * std::sqrt(9.81 * depth));
    const auto zone = [](double x) {
        return Zone({Box{Vec3(x - 0.2, -infinite, -0.6), Vec3(x + 0.2, infinite, -0.2)}});
    };
    s.zones = {zone(-way / 2)};
    double time = 0;
    s.zones_round = [&](std::span<const MovedSolid>) {
        return std::vector<Zone>{zone(-way / 2 + std::min(speed * time, way))};
    };
    Simulation simulation = filled(s);
    Stirred r;
    double squares = 0;
    int times = 0;
    while (time < 1.6) {
        simulation.step(), time = simulation.time();
        for (const auto& level : simulation.levels()) r.fastest = std::max(r.fastest, level->system().extremes.speed);
        if (time > 0.8) squares += mean_square_velocity(simulation.finest()), ++times;
    }
    const double wave_speed = std::sqrt(9.81 * depth);
    r.rms = std::sqrt(squares / times) / wave_speed, r.fastest /= wave_speed;
    const Refinement& edge = simulation.refinements()[0];
    r.surplus = edge.surplus() / (s.rho0 * 0.4 * 0.4), r.splits = edge.ledger().splits;
    r.orphans = edge.ledger().orphans;
    return r;
}

// What an edge in still water drives is small and not made larger by its motion over twice the zone's length.
TEST(MovingZone, ThroughStillWaterMovesNoMoreThanAZoneThatStands) {
    const Stirred r = still_water();
    std::printf(
        "still water over sqrt(g H): fine particles' rms %.4f, fastest of all %.4f; surplus of the zone's mass "
        "%+.4f; %lld births\n",
        r.rms, r.fastest, r.surplus, static_cast<long long>(r.splits));
    EXPECT_LT(r.rms, 0.018);
    EXPECT_LT(std::abs(r.surplus), 0.03);
    EXPECT_LE(r.orphans, 2);  // a coarse particle at a corner of the zone sees a quarter of the fine water
    EXPECT_GT(r.splits, 2 * 40 * 40) << "or the zone has not moved twice its length";
}

/// A cylinder of 1000 kg/m3 at 2.955 m/s on the surface; sizes of particles: one or three.
SimulationSetup cylinder(bool levels, int threads = 1) {
    const double dp = 0.01;
    SimulationSetup s = tank(dp, 0.96, 0.64, 0.4, 40);
    s.threads = threads;
    s.bodies = {circle_body(0.11, 0, 1000)};
    s.bodies[0].moving->velocity = Vec3(0, 0, -2.955);
    s.bodies[0].moving->free = {{false, false, true}, {false, false, false}};
    if (!levels) return s;
    s.zones_round = [dp](std::span<const MovedSolid> moving) {
        std::vector<Zone> zones;
        for (const double width : {26 * dp, 12 * dp}) {
            const Box& body = moving[0].bounds;
            zones.emplace_back(std::vector<Box>{{Vec3(body.min.x() - width, -infinite, body.min.z() - width),
                                                 Vec3(body.max.x() + width, infinite, infinite)}});
        }
        return zones;
    };
    s.zones = s.zones_round(std::vector<MovedSolid>{Body::of(s.bodies[0])->moved()});
    return s;
}

TEST(MovingZone, RoundACylinderLetsItEnterAsParticlesOfOneSizeDo) {
    Simulation one = filled(cylinder(false)), three = filled(cylinder(true));
    const double start = centre_of(one).z();
    std::size_t most = 0;
    double before = 0, before3 = 0, from = 0;
    for (const double time : {0.01, 0.05, 0.1}) {
        run_to(one, time), run_to(three, time);
        std::size_t particles = 0;
        for (const auto& level : three.levels()) particles += level->fields().particles().size();
        most = std::max(most, particles);
        // steps of the two do not end at the same time
        const auto way_of = [&](const Simulation& s) {
            return start - centre_of(s).z() + speed_up(s) * (s.time() - time);
        };
        const double way = way_of(one), way3 = way_of(three);
        // The mean over the time since: sound that goes to and fro in the tank makes the speed of a moment swing by 4 %.
        const double speed = (way - before) / (time - from), speed3 = (way3 - before3) / (time - from);
        std::printf(
            "cylinder from %.2f to %.2f s: way %.4f m, mean speed %.3f m/s; with three sizes %.4f m, %.3f m/s\n", from,
            time, way, speed, way3, speed3);
        EXPECT_NEAR(way3 / way, 1, 0.01);
        EXPECT_NEAR(speed3 / speed, 1, 0.02);
        before = way, before3 = way3, from = time;
    }
    EXPECT_LT(most, 0.6 * double(one.particles().size()));
}

// Where its zone does not follow, a body ends the run before it meets coarse particles.
TEST(MovingZone, ThatStaysBehindEndsTheRunAndSaysSo) {
    SimulationSetup s = cylinder(true);
    s.zones_round = [start = s.zones](std::span<const MovedSolid>) { return start; };
    Simulation simulation = filled(s);
    try {
        run_to(simulation, 0.1);
        FAIL() << "the run went on";
    } catch (const RunError& e) {
        EXPECT_NE(std::string(e.what()).find("edge of the finest particles ([sph] zone)"), std::string::npos)
            << e.what();
    }
}

TEST(MovingZone, GivesTheSameBitsWithAnyNumberOfThreadsAndAfterARestart) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "moving_zone_test.h5";
    Simulation whole = filled(cylinder(true)), three = filled(cylinder(true, 3));
    const auto same = [](const Simulation& a, const Simulation& b) {
        for (std::size_t k = 0; k < a.levels().size(); ++k) {
            const Particles &p = a.level(k).fields().particles(), &q = b.level(k).fields().particles();
            if (p.id != q.id || p.x != q.x || p.z != q.z || p.u != q.u || p.w != q.w || p.drho != q.drho ||
                p.kind != q.kind)
                return false;
        }
        return centre_of(a) == centre_of(b) && speed_up(a) == speed_up(b);
    };
    for (int k = 0; k < 20; ++k) whole.step(), three.step();
    EXPECT_TRUE(same(whole, three));
    write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
    whole.mark_restart_point();
    Simulation resumed = filled(cylinder(true, 2));
    restore(resumed, read_checkpoint(file, "a scene"));
    for (int k = 0; k < 20; ++k) whole.step(), resumed.step();
    EXPECT_TRUE(same(whole, resumed));
    PointSamples here{{Vec3(0.3, 0, -0.3), Vec3(0.08, 0, -0.1)}, false, {}, {}, {}}, there = here;
    whole.sample(here), resumed.sample(there);
    EXPECT_EQ(here.p, there.p);
    EXPECT_GT(whole.refinements()[1].ledger().splits, 0);
    std::filesystem::remove(file);
}

}  // namespace moving_zone_test
}  // namespace tw
