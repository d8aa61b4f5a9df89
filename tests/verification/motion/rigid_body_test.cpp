#include "motion/rigid_body.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace rigid_body_test {

RigidBodySetup brick() {
    RigidBodySetup s;
    s.mass.mass = 2;
    s.mass.centre = Vec3(0.1, -0.2, 0.3);
    s.mass.inertia = Vec3(1, 2, 2.5).asDiagonal();
    return s;
}

/// A kick-drift-kick step under the load at the middle of the drift.
template <class LoadAt>
void step(RigidBody& body, double dt, const LoadAt& load) {
    body.drift(dt / 2);
    const auto [force, moment] = load(body);
    body.kick(force, moment, dt);
    body.drift(dt / 2);
}
using Loads = std::pair<Vec3, Vec3>;

TEST(RigidBody, FallsFreelyAsTheFormulaSays) {
    RigidBodySetup s = brick();
    s.velocity = Vec3(1, 0, 2);
    RigidBody body(s);
    const Vec3 g(0, 0, -9.81);
    double t = 0;
    for (int k = 0; k < 1000; ++k, t += 1e-3)
        step(body, 1e-3, [&](const RigidBody&) { return Loads(2 * g, Vec3::Zero()); });
    const Vec3 exact = s.mass.centre + s.velocity * t + 0.5 * g * t * t;
    EXPECT_LT((body.state().centre - exact).norm(), 1e-12);
    EXPECT_LT((body.state().velocity - (s.velocity + g * t)).norm(), 1e-12);
}

/// Turns of a torque-free top whose spin is near its middle axis, so that it tumbles.
struct Top {
    double energy, momentum;  ///< largest relative change
    Eigen::Quaterniond attitude;
};
Top spun(double dt, double seconds, const DegreesOfFreedom& free = {}) {
    RigidBodySetup s = brick();
    s.mass.inertia(0, 1) = s.mass.inertia(1, 0) = 0.2;  // not along the principal axes
    s.spin = Vec3(0.05, 2 * pi, 0.03);
    s.free = free;
    RigidBody body(s);
    const double energy = body.kinetic_energy();
    const Vec3 momentum = body.state().angular_momentum;
    Top top{0, 0, {}};
    for (double t = 0; t < seconds - dt / 2; t += dt) {
        body.drift(dt);
        top.energy = std::max(top.energy, std::abs(body.kinetic_energy() / energy - 1));
        const Eigen::Matrix3d turn = body.state().attitude.toRotationMatrix();
        const Vec3 now = turn * (body.mass().inertia * (turn.transpose() * body.spin()));
        top.momentum = std::max(top.momentum, (now - momentum).norm() / momentum.norm());
    }
    top.attitude = body.state().attitude;
    return top;
}

TEST(RigidBody, SpinsWithoutTorqueKeepingEnergyAndAngularMomentumToAMillionth) {
    const Top top = spun(1e-4, 50);  // 50 turns, through several tumbles
    EXPECT_LT(top.energy, 1e-6);
    EXPECT_LT(top.momentum, 1e-12);
    EXPECT_GT(spun(1e-2, 50).energy, 1e-6) << "or this test sees nothing";
}

TEST(RigidBody, TurnsWithSecondOrderInTheStep) {
    const Eigen::Quaterniond exact = spun(1e-4, 2).attitude;
    const double coarse = exact.angularDistance(spun(8e-3, 2).attitude),
                 fine = exact.angularDistance(spun(4e-3, 2).attitude);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << coarse << " " << fine;
}

TEST(RigidBody, SwingsOnASpringWithSecondOrderInTheStep) {
    const auto error = [&](double dt) {
        RigidBodySetup s = brick();
        s.mass.centre = Vec3::Zero();
        s.velocity = Vec3(0, 0, 1);
        s.free = {{false, false, true}, {false, false, false}};
        RigidBody body(s);
        const double stiffness = 2 * 4 * pi * pi;  // of 2 kg: a period of 1 s
        for (int n = 0; n < std::lround(10 / dt); ++n)
            step(body, dt, [&](const RigidBody& b) {
                return Loads(Vec3(0, 0, -stiffness * b.state().centre.z()), Vec3::Zero());
            });
        return std::abs(body.state().centre.z());  // passes zero after whole periods
    };
    EXPECT_NEAR(std::log2(error(0.01) / error(0.005)), 2, 0.05);
    EXPECT_LT(error(0.001), 1e-3);
}

TEST(RigidBody, KeepsLockedDegreesOfFreedomLocked) {
    RigidBodySetup s = brick();
    s.mass.inertia(0, 1) = s.mass.inertia(1, 0) = 0.3;  // a roll moment would also pitch it
    s.free = {{false, true, true}, {true, false, true}};
    s.velocity = s.spin = Vec3(1, 1, 1);
    RigidBody body(s);
    for (int k = 0; k < 500; ++k)
        step(body, 1e-2, [](const RigidBody&) { return Loads(Vec3(3, -2, 1), Vec3(0.3, 5, -0.2)); });
    EXPECT_EQ(body.state().centre.x(), 0.1);
    EXPECT_EQ(body.state().velocity.x(), 0);
    EXPECT_EQ(body.spin().y(), 0);
    EXPECT_NE(body.spin().x(), 0);
    EXPECT_NE(body.state().velocity.z(), 0);
}

TEST(RigidBody, WithALockedAxisKeepsTheEnergyOfTheFreeOnes) {
    EXPECT_LT(spun(1e-4, 5, {{true, true, true}, {true, true, false}}).energy, 1e-6);
}

TEST(RigidBody, WithOneFreeAxisTurnsAsThePlaneFormulaSays) {
    RigidBodySetup s = brick();
    s.free = {{false, false, false}, {false, true, false}};
    RigidBody body(s);
    const double moment = 0.7, t = 3;
    for (int k = 0; k < 300; ++k)
        step(body, t / 300, [&](const RigidBody&) { return Loads(Vec3::Zero(), Vec3(0, moment, 0)); });
    const Eigen::Quaterniond exact(Eigen::AngleAxisd(0.5 * moment / 2 * t * t, Vec3::UnitY()));
    EXPECT_LT(exact.angularDistance(body.state().attitude), 1e-7);
}

TEST(RigidBody, StaysUntilItIsReleasedAndFallsFromThenOn) {
    RigidBodySetup s = brick();
    s.release = 0.5;
    RigidBody body(s);
    const auto weight = [&](const RigidBody&) { return Loads(Vec3(0, 0, -9.81 * s.mass.mass), Vec3(0, 0.1, 0)); };
    for (int k = 0; k < 50; ++k) step(body, 1e-2, weight);
    EXPECT_EQ(body.state().centre, s.mass.centre);
    EXPECT_EQ(body.state().attitude.w(), 1);
    for (int k = 0; k < 50; ++k) step(body, 1e-2, weight);
    EXPECT_NEAR(body.state().centre.z() - s.mass.centre.z(), -9.81 / 2 * 0.25, 0.02) << "to one step of free fall";
    EXPECT_LT(body.state().attitude.w(), 1);
}

TEST(RigidBody, FollowsAPrescribedMotionWhateverTheLoads) {
    RigidBodySetup s = brick();
    s.law = MotionLaw{
        .kind = MotionLaw::Kind::sinusoid, .turns = true, .axis = Vec3::UnitY(), .amplitude = 0.2, .period = 2};
    RigidBody body(s);
    for (int k = 0; k < 50; ++k)
        step(body, 1e-2, [](const RigidBody&) { return Loads(Vec3(1e3, 0, 0), Vec3(1e3, 0, 0)); });
    EXPECT_NEAR(body.state().time, 0.5, 1e-12);
    EXPECT_NEAR(Eigen::AngleAxisd(body.state().attitude).angle(), 0.2, 1e-9);
    EXPECT_EQ(body.state().centre, s.mass.centre);
    EXPECT_NEAR(body.spin().y(), 0, 1e-9);
    EXPECT_NEAR(body.prescribed_angular_acceleration().y(), -0.2 * pi * pi, 1e-9);
}

}  // namespace rigid_body_test
}  // namespace tw
