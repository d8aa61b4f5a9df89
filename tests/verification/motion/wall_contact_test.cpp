// A body on a floor and at walls, judged by the laws of a rigid body and of dry friction.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate.h"
#include "motion/wall_contact.h"

namespace tw {
namespace wall_contact_test {

constexpr double g = 9.81, dt = 2.5e-4;
const WallPlane ground{Vec3::UnitZ(), 0};

/// A box of 1200 kg/m3 on the floor z = 0, its middle over the origin.
struct Block {
    Surface surface;
    RigidBody body;
    WallContact contact;

    Block(const Vec3& size, double friction, std::vector<WallPlane> walls = {ground}, double lifted = 0,
          const DegreesOfFreedom& free = {}, const Vec3& velocity = Vec3::Zero())
        : surface(box(size, lifted)), body(setup(surface, free, velocity)), contact(surface.points, walls, friction) {}

    static Surface box(const Vec3& size, double lifted) {
        const Surface s = make_hull("box", {{"length", size.x()}, {"beam", size.y()}, {"height", size.z()}});
        return posed(s, {.draft = -lifted});
    }
    static RigidBodySetup setup(const Surface& surface, const DegreesOfFreedom& free, const Vec3& velocity) {
        RigidBodySetup b;
        b.mass = solid_mass(surface, 1200);
        b.free = free;
        b.velocity = velocity;
        return b;
    }
    double mass() const { return body.mass().mass; }
    Vec3 moved() const { return body.state().centre - body.mass().centre; }
    double turned() const { return Eigen::AngleAxisd(body.state().attitude).angle(); }
    double energy() const { return body.kinetic_energy() + mass() * g * body.state().centre.z(); }

    /// Under an acceleration that all of it feels, and a force at a place of it [m/s2], [N], [m].
    WallReaction step(const Vec3& felt, const Vec3& force = Vec3::Zero(), const Vec3& at = Vec3::Zero()) {
        const Vec3 arm = body.now(at) - body.state().centre;
        body.kick(mass() * felt + force, arm.cross(force), dt);
        const WallReaction r = contact.resist(body, dt);
        body.drift(dt);
        return r;
    }
    void run(double time, const Vec3& felt, const Vec3& force = Vec3::Zero(), const Vec3& at = Vec3::Zero()) {
        for (double t = 0; t < time - dt / 2; t += dt) step(felt, force, at);
    }
};

/// Gravity as a floor that is tilted by an angle [rad] about y feels it.
Vec3 tilted(double angle) { return g * Vec3(std::sin(angle), 0, -std::cos(angle)); }
const Vec3 weight = tilted(0);

TEST(WallContact, ABlockStandsOnTheFloorWithoutSinkingOrTrembling) {
    Block block({0.2, 0.1, 0.3}, 0.5);
    for (int k = 0; k < 4000; ++k) {
        const WallReaction r = block.step(weight);
        ASSERT_NEAR(r.impulse.z() / dt, block.mass() * g, 1e-6 * block.mass() * g);
        ASSERT_LT(block.body.state().velocity.norm(), 1e-9) << k;
        ASSERT_LT(block.body.spin().norm(), 1e-8) << k;
    }
    EXPECT_LT(block.moved().norm(), 1e-9);
    EXPECT_LT(block.turned(), 1e-8);
}

/// It sticks below tan(angle) = mu, and beyond slides with g (sin - mu cos); with no friction with g sin.
TEST(WallContact, ABlockSlidesDownAnInclineAsCoulombSays) {
    for (const double mu : {0.0, 0.3, 0.7})
        for (const double angle : {std::atan(mu) - 0.002, std::atan(mu) + 0.002, std::atan(mu) + 0.2}) {
            if (angle < 0) continue;
            Block block({0.4, 0.4, 0.1}, mu);
            block.run(0.5, tilted(angle));
            const double a = std::max(0.0, g * (std::sin(angle) - mu * std::cos(angle)));
            EXPECT_NEAR(block.body.state().velocity.x(), 0.5 * a, 1e-9 + 1e-6 * a) << mu << " at " << angle;
            EXPECT_NEAR(block.moved().x(), 0.125 * a, 1e-9 + 3e-4 * a) << mu << " at " << angle;
            EXPECT_LT(block.turned(), 1e-9);
        }
}

/// Thrown along the floor it comes to rest after v^2 / (2 mu g), whichever way it goes.
TEST(WallContact, ABlockThatSlidesStopsAfterItsWay) {
    const Vec3 v(1.2, -0.9, 0);
    Block block({0.5, 0.5, 0.1}, 0.4, {ground}, 0, {}, v);
    block.run(0.8, weight);
    const double way = v.squaredNorm() / (2 * 0.4 * g);
    EXPECT_LT((block.moved() - way * v.normalized()).norm(), 1e-3 * way);
    EXPECT_LT(block.body.state().velocity.norm(), 1e-9);
}

/// A block of breadth b and height h tips over its edge beyond tan(angle) = b / h, when it does not slide before.
TEST(WallContact, ABlockTipsWhereTheMomentWins) {
    const double b = 0.1, h = 0.4, edge = std::atan(b / h);
    for (const double off : {-0.002, 0.002}) {
        Block block({b, 0.3, h}, 2);
        block.run(1, tilted(edge + off));
        if (off < 0) {
            EXPECT_LT(block.turned(), 1e-9);
        } else {
            // from rest on the edge: (I + m r^2) theta'' = m g r sin(theta + off), to 3rd order theta = off (cosh(k t)
            // - 1)
            const double r = std::hypot(b, h) / 2, k = std::sqrt(g / (4.0 / 3 * r));
            EXPECT_NEAR(block.turned(), off * (std::cosh(k) - 1), 0.01 * off * std::cosh(k));
            const double slid = (block.body.now(Vec3(b / 2, 0.15, 0)) - Vec3(b / 2, 0.15, 0)).norm();
            EXPECT_LT(slid, 1e-5) << "the edge stays where it is";
        }
    }
    // pushed at its top it tips at F = m g b / (2 h), pushed at the floor it slides at mu m g
    for (const double share : {0.99, 1.01}) {
        Block high({b, 0.3, h}, 0.5), low({b, 0.3, h}, 0.1);
        high.run(0.3, weight, Vec3(share * high.mass() * g * b / (2 * h), 0, 0), Vec3(0, 0, h));
        low.run(0.3, weight, Vec3(share * 0.1 * low.mass() * g, 0, 0), Vec3(0, 0, 0));
        EXPECT_EQ(high.turned() > 1e-6, share > 1);
        EXPECT_EQ(low.moved().x() > 1e-6, share > 1);
        EXPECT_LT(low.turned(), 1e-9);
        EXPECT_LT(std::abs(high.body.now(Vec3(b / 2, 0, 0)).x() - b / 2), 1e-6);
    }
}

/// It falls on its face: what it has left is nothing, at no moment more than before. On an edge it goes on turning with
/// the angular momentum about that edge, which the blow leaves alone.
TEST(WallContact, ABlockThatFallsStaysDown) {
    Block flat({0.2, 0.2, 0.2}, 0.5, {ground}, 0.05);
    double energy = flat.energy();
    for (double t = 0; t < 0.5; t += dt) {
        flat.step(weight);
        ASSERT_LT(flat.energy(), energy + 1e-3 * flat.mass() * g * g * dt * dt + 1e-6) << t;
        energy = flat.energy();
        ASSERT_GT(flat.contact.gap(flat.body), -1e-9);
    }
    EXPECT_NEAR(flat.moved().z(), -0.05, 1e-6);
    EXPECT_LT(flat.body.kinetic_energy(), 1e-20);

    Block tipped({0.2, 0.4, 0.2}, 10, {ground}, 0.2);
    RigidBody::State s = tipped.body.state();
    const double angle = 0.3, v = 1;
    s.attitude = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    s.velocity = Vec3(0, 0, -v);
    tipped.body.set_state(s);
    s.centre.z() -= tipped.contact.gap(tipped.body);
    tipped.body.set_state(s);
    tipped.contact.resist(tipped.body, dt);
    // turned bow up by 0.3 about y the low corner is at (0.1, -0.1): about it L = m v x the arm's x
    const Vec3 arm = Eigen::AngleAxisd(angle, Vec3::UnitY()) * Vec3(0.1, 0, -0.1);
    const double about_edge = tipped.body.mass().inertia(1, 1) + tipped.mass() * 0.02;
    EXPECT_NEAR(tipped.body.spin().y(), -tipped.mass() * v * arm.x() / about_edge, 1e-9);
    EXPECT_LT((tipped.body.state().velocity + tipped.body.spin().cross(arm)).norm(), 1e-9);
}

/// In a corner of floor and two walls, pressed into it along all axes at once, friction or none.
TEST(WallContact, HoldsInACornerAndUpsideDown) {
    for (const double mu : {0.0, 0.6}) {
        Block block({0.2, 0.2, 0.2}, mu, {ground, {Vec3::UnitX(), -0.1}, {-Vec3::UnitY(), -0.1}});
        const Vec3 felt(-5, 7, -g);
        block.run(0.5, felt);
        EXPECT_LT(block.moved().norm(), 1e-8) << mu;
        EXPECT_LT(block.turned(), 1e-7) << mu;
    }
    Block under({0.2, 0.2, 0.2}, 0.5, {{-Vec3::UnitZ(), -0.2}});
    under.run(0.5, Vec3(0, 0, 3));
    EXPECT_LT(under.moved().norm(), 1e-9) << "a light body under a lid";
}

TEST(WallContact, OfLockedMotionsIsNone) {
    DegreesOfFreedom surge;
    surge.along = {true, false, false}, surge.about = {false, false, false};
    Block block({0.2, 0.2, 0.2}, 0.5, {ground, {-Vec3::UnitX(), -0.2}}, 0, surge);
    block.run(0.1, Vec3(1, 0, -g));
    EXPECT_NEAR(block.moved().x(), 0.5 * 0.01, 2e-5) << "heave carries the weight, so the floor gives no friction";
    block.run(0.9, Vec3(1, 0, -g));
    EXPECT_NEAR(block.moved().x(), 0.1, 1e-9) << "and the wall stops it";
}

/// Where water needs room it comes to rest with that between it and the floor, unless it has stood there from the
/// start.
TEST(WallContact, KeepsRoomForWaterWhereItHasBeenClear) {
    for (const double lifted : {0.0, 0.005, 0.02, 0.05}) {
        Block block({0.2, 0.2, 0.2}, 0.5, {ground}, lifted);
        block.contact.keep_room(0.02);
        block.run(0.3, weight);
        EXPECT_NEAR(block.contact.gap(block.body), lifted < 0.02 ? 0 : 0.02, 1e-6) << lifted;
    }
}

/// A ball of facets and a disc with more corners than are solved at once.
TEST(WallContact, RoundBodiesRollAndStand) {
    const Surface can = make_hull("cylinder", {{"diameter", 0.2}, {"span", 0.1}});
    RigidBodySetup setup;
    setup.mass = solid_mass(can, 500);
    RigidBody body(setup);
    const double low = can.bounds().min.z();
    WallContact contact(can.points, {{Vec3::UnitZ(), low}, {Vec3::UnitY(), can.bounds().min.y()}}, 0.5);
    for (double t = 0; t < 0.5; t += dt) {
        body.kick(setup.mass.mass * Vec3(0, -3, -g), Vec3::Zero(), dt);  // on its side, an end against a wall
        contact.resist(body, dt);
        body.drift(dt);
    }
    EXPECT_LT((body.state().centre - setup.mass.centre).norm(), 1e-4);
    EXPECT_GT(contact.gap(body), -1e-9);
}

}  // namespace wall_contact_test
}  // namespace tw
