// Bodies that stand on the floor of a tank: under gravity, in still water that rises round them, and before a flow.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "sph_solver/bodies/water_film.h"
#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"
#include "tests/verification/sph_solver/bodies.h"

namespace tw {
namespace body_on_floor_test {

/// A box on the floor z = -depth in the middle of a tank, free in the plane.
BodySetup standing(const SimulationSetup& s, double width, double height, double density, double friction = 0.5,
                   double gap = 0) {
    BodySetup body = box_body(width, height, -s.domain.min.z() - gap, density);
    std::vector<Vec3> corners = body.surface.points;
    for (Vec3& corner : corners) corner.y() = 0;
    body.contact = WallContact(
        corners,
        {{Vec3::UnitZ(), s.domain.min.z()}, {Vec3::UnitX(), s.domain.min.x()}, {-Vec3::UnitX(), -s.domain.max.x()}},
        friction);
    return body;
}

/// A puddle at the far wall, so that the tank is not empty.
Fluid puddle(const SimulationSetup& s) {
    Box corner = s.domain;
    corner.min.x() = corner.max.x() - 6 * s.dp;
    corner.max.z() = corner.min.z() + 4 * s.dp;
    return fill_with_fluid(s, {corner});
}

TEST(BodyOnFloor, StandsOnADryFloor) {
    SimulationSetup s = tank(0.02, 0.6, 0.3, 0.3, 10);
    s.bodies = {standing(s, 0.2, 0.2, 1500)};
    Simulation run(s, puddle(s));
    run_to(run, 0.3);
    EXPECT_LT((centre_of(run) - rigid_of(run.body(0)).mass().centre).norm(), 1e-9);
    EXPECT_LT(turned_by(run), 1e-9);
    EXPECT_LT(rigid_of(run.body(0)).state().velocity.norm(), 1e-9);
}

/// Gravity that leans by more than the angle of friction lets it slide: g (sin - mu cos).
TEST(BodyOnFloor, SlidesWhereGravityLeansBeyondTheAngleOfFriction) {
    for (const double angle : {0.25, 0.35}) {  // tan: 0.255, 0.365
        SimulationSetup s = tank(0.02, 0.6, 0.3, 0.3, 10);
        s.gravity = 9.81 * Vec3(std::sin(angle), 0, -std::cos(angle));
        s.bodies = {standing(s, 0.2, 0.1, 1500, 0.3)};
        Simulation run(s, puddle(s));
        run_to(run, 0.1);
        const double begin = run.time(), before = rigid_of(run.body(0)).state().velocity.x();
        run_to(run, 0.2);
        const double gained = rigid_of(run.body(0)).state().velocity.x() - before, time = run.time() - begin;
        const double friction = 9.81 * 0.3 * std::cos(angle), pull = 9.81 * std::sin(angle);  // [m/s2]
        const double a = std::max(0.0, pull - friction);
        EXPECT_NEAR(gained, a * time, a > 0 ? 0.01 * friction * time : 1e-9) << angle;  // found 0.6 % of the friction
    }
}

/// In still water of depth d a block rises that weighs less than the water it displaces, though no particle fits under
/// it at the start.
TEST(BodyOnFloor, IsLiftedByWaterThatIsDeepEnough) {
    const double height = 0.2, depth = 0.15, dp = 0.01;
    SimulationSetup s = tank(dp, 0.4, depth, 0.3, 20);
    s.bodies = {standing(s, 0.2, height, 0.8 * 1000 * depth / height)};
    Simulation run(s, water(s));
    const double start = centre_of(run).z();
    run_to(run, 0.6);
    EXPECT_GT(centre_of(run).z() - start, dp);
    EXPECT_LT(std::abs(centre_of(run).x()), 4 * dp);  // nothing holds it: found 2.8 dp
    EXPECT_LT(turned_by(run), 0.4);  // a square of this density does not float upright: found 0.2
}

/// Between water of depth d on one side and none on the other the pressure under a block falls linearly: half of
/// rho g d on its length, a third of the length from the wet side.
TEST(BodyOnFloor, FeelsALinearUpliftBetweenAWetAndADryRim) {
    const double dp = 0.01, length = 0.3;
    const BodySetup box = box_body(length, 0.2, 0, 1000);
    const RigidBody body(*box.moving);
    std::vector<Vec3> corners = box.surface.points;
    for (Vec3& c : corners) c.y() = 0;
    const WallContact walls(corners, {{Vec3::UnitZ(), 0}}, 0.5);
    const WaterFilm film(box.surface, 2, dp);
    EXPECT_EQ(film.share(dp), 1);
    EXPECT_EQ(film.share(2 * dp), 0);
    PointSamples felt{film.places(body), false, {}, {}, {}};
    const double depth = 0.1;
    for (const Vec3& x : felt.places) {
        const bool wet = x.x() < -length / 2 + 1e-9 && x.z() < depth;
        felt.support.push_back(wet ? 0.5f : 0.0f);
        felt.p.push_back(wet ? static_cast<float>(9810 * (depth - x.z())) : 0.0f);
    }
    const Load load = film.load(body, walls, felt, Vec3(0, 0, -9810));
    const double up = 9810 * depth * length / 2, side = 9810 * depth * depth / 2;
    EXPECT_NEAR(load.force.z(), up, 0.02 * up);
    EXPECT_NEAR(load.force.x(), side, 0.02 * side);
    // about y through the centre, 0.1 m up: the uplift's arm is length/6 towards low x, the side's depth/3 - 0.1 up
    const double about_y = up * length / 6 + side * (depth / 3 - 0.1);
    EXPECT_NEAR(load.moment.y(), about_y, 0.03 * up * length / 6);
}

/// Wet all round up to a depth the film has the pressure of the depth, and lifts as Archimedes says, upright.
TEST(BodyOnFloor, FeelsArchimedesLiftWhereItsRimIsWetAllRound) {
    const double depth = 0.15;
    const Surface box = posed(make_hull("box", {{"length", 0.2}, {"beam", 0.3}, {"height", 0.2}}), {.draft = 0});
    RigidBodySetup setup;
    setup.mass = solid_mass(box, 500);
    const RigidBody body(setup);
    const WallContact walls(box.points, {{Vec3::UnitZ(), 0}}, 0.5);
    const WaterFilm film(box, 3, 0.02);
    PointSamples felt{film.places(body), false, {}, {}, {}};
    for (const Vec3& x : felt.places) {
        const bool wet = x.z() > 1e-9 && x.z() < depth;
        felt.support.push_back(wet ? 0.5f : 0.0f);
        felt.p.push_back(wet ? static_cast<float>(9810 * (depth - x.z())) : 0.0f);
    }
    const Load load = film.load(body, walls, felt, Vec3(0, 0, -9810));
    const double up = 9810 * depth * 0.2 * 0.3;
    EXPECT_NEAR(load.force.z(), up, 1e-4 * up);
    EXPECT_LT(load.force.head<2>().norm(), 1e-4 * up);
    EXPECT_LT(load.moment.norm(), 1e-5 * up);
}

/// However finely a body is triangulated, its film has patches of about the particles' spacing, and water all round
/// lifts it as Archimedes says. (128 sides at five spacings in the diameter took 1.1 GB before.)
TEST(BodyOnFloor, HasAsManyPatchesAsSpacingsHoweverFineItsTriangles) {
    const double dp = 0.01, radius = 0.025, span = 0.2, depth = 0.15;
    const double surface = 2 * std::numbers::pi * radius * (span + radius);
    for (const double segments : {128.0, 2048.0}) {
        const Surface cylinder =
            posed(make_hull("cylinder", {{"diameter", 2 * radius}, {"span", span}, {"segments", segments}}), {.draft = 0});
        RigidBodySetup setup;
        setup.mass = solid_mass(cylinder, 500);
        const RigidBody body(setup);
        const WallContact walls(cylinder.points, {{Vec3::UnitZ(), 0}}, 0.5);
        const WaterFilm film(cylinder, 3, dp);
        PointSamples felt{film.places(body), false, {}, {}, {}};
        EXPECT_LT(double(felt.places.size()), 16 * surface / (dp * dp)) << segments;
        for (const Vec3& x : felt.places)
            felt.support.push_back(0.5f), felt.p.push_back(static_cast<float>(9810 * (depth - x.z())));
        const Load load = film.load(body, walls, felt, Vec3(0, 0, -9810));
        const double up = 9810 * std::numbers::pi * radius * radius * span;
        EXPECT_NEAR(load.force.z(), up, 0.02 * up) << segments;
        EXPECT_LT(load.force.head<2>().norm(), 1e-3 * up) << segments;
    }
}

std::vector<double> pushed(int threads, bool restart) {
    SimulationSetup s = tank(0.02, 0.6, 0.3, 0.3, 20);
    s.threads = threads;
    s.bodies = {standing(s, 0.16, 0.16, 700)};
    Box column = s.domain;
    column.max.x() = -0.2;
    column.max.z() = 0;
    const Fluid fluid = fill_with_fluid(s, {column});
    Simulation run(s, fluid);
    run_to(run, 0.25);
    if (!restart) {
        run.mark_restart_point();
        run_to(run, 0.5);
        return run.body(0).state();
    }
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "twinwake_floor_checkpoint.h5";
    write_checkpoint(file, "hash", checkpoint_of(run, 1));
    Simulation resumed(s, fluid);
    restore(resumed, read_checkpoint(file, "hash"));
    std::filesystem::remove(file);
    run_to(resumed, 0.5);
    return resumed.body(0).state();
}

/// A dam break strikes it and carries it along the floor; threads and restarts leave the bits alone.
TEST(BodyOnFloor, IsCarriedOffByADamBreakToTheSameBits) {
    const std::vector<double> one = pushed(1, false);
    EXPECT_GT(one[5], 0.05) << "how far its centre has come along x [m]";
    EXPECT_EQ(one, pushed(3, false));
    EXPECT_EQ(one, pushed(1, true));
}

}  // namespace body_on_floor_test
}  // namespace tw
