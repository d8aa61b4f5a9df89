#include "motion/moving_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace tw {
namespace moving_frame_test {

const Vec3 g(0, 0, -9.81);

MotionLaw rolling() {
    MotionLaw law;
    law.kind = MotionLaw::Kind::sinusoid;
    law.turns = true;
    law.axis = Vec3(1, 2, -0.5).normalized();
    law.amplitude = 0.7, law.period = 1.3, law.phase = 0.4;
    return law;
}

MotionLaw swaying() {
    MotionLaw law = rolling();
    law.turns = false;
    return law;
}

/// Where a place of the earth is in the tank's axes.
Vec3 in_tank(const MovingFrame& frame, const Vec3& earth, double t) {
    const double s = frame.law.at(t).path;
    if (!frame.law.turns) return earth - s * frame.law.axis;
    return frame.pivot + Eigen::AngleAxisd(-s, frame.law.axis) * (earth - frame.pivot);
}

/// What falls freely in the earth does so in the tank's axes as well: Newton's law there, by Runge-Kutta, from its
/// place and velocity in the tank at the start. The force `of` a moment may be changed.
template <class Change>
double error_of_free_fall(const MovingFrame& frame, const Change& change) {
    const Vec3 at_start(0.3, -0.2, 1), velocity(1, 0.5, 2);
    const auto earth = [&](double t) { return Vec3(at_start + t * velocity + t * t / 2 * g); };
    const double e = 1e-4;
    Vec3 x = in_tank(frame, earth(0), 0), u = (in_tank(frame, earth(e), e) - in_tank(frame, earth(-e), -e)) / (2 * e);
    const int steps = 4000;
    const double dt = 1.0 / steps;
    const auto f = [&](double t, const Vec3& place, const Vec3& speed) {
        FrameForce force = frame.force(t, g);
        change(force);
        return force.at(place, speed);
    };
    for (int n = 0; n < steps; ++n) {
        const double t = n * dt;
        const Vec3 u1 = u, a1 = f(t, x, u1);
        const Vec3 u2 = u + dt / 2 * a1, a2 = f(t + dt / 2, x + dt / 2 * u1, u2);
        const Vec3 u3 = u + dt / 2 * a2, a3 = f(t + dt / 2, x + dt / 2 * u2, u3);
        const Vec3 u4 = u + dt * a3, a4 = f(t + dt, x + dt * u3, u4);
        x += dt / 6 * (u1 + 2 * u2 + 2 * u3 + u4);
        u += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return (x - in_tank(frame, earth(1), 1)).norm();
}

TEST(MovingFrame, WhatFallsFreelyInTheEarthFallsByItsForces) {
    const auto as_it_is = [](FrameForce&) {};
    for (const MotionLaw& law : {rolling(), swaying()})
        EXPECT_LT(error_of_free_fall({law, Vec3(0.5, 0.1, -0.4)}, as_it_is), 1e-6) << law.turns;
    // each part counts
    const MovingFrame frame{rolling(), Vec3(0.5, 0.1, -0.4)};
    EXPECT_GT(error_of_free_fall(frame, [](FrameForce& f) { f.spin.setZero(); }), 0.1);
    EXPECT_GT(error_of_free_fall(frame, [](FrameForce& f) { f.gradient.setZero(); }), 0.1);
    EXPECT_GT(error_of_free_fall(frame, [](FrameForce& f) { f.at_pivot = g; }), 0.1);
}

/// A body without loads that tumbles in the earth, without gravity: seen from a tank that rolls it is where it would be
/// seen, turned as it would be, after a second of kick-drift-kick. `keep`: of what the frame does.
template <class Keep>
double error_of_a_tumbling_body(int steps, const Keep& keep) {
    const MovingFrame frame{rolling(), Vec3(0.5, 0.1, -0.4)};
    RigidBodySetup of;
    of.mass = {.mass = 2, .centre = Vec3(0.3, -0.2, 1), .inertia = Vec3(1, 2, 2.5).asDiagonal()};
    of.velocity = Vec3(1, 0.5, 2);
    of.spin = Vec3(0.8, 2, -0.5);
    const double dt = 1.0 / steps;
    RigidBody earth(of);
    for (int n = 0; n < 20000; ++n) earth.drift(1.0 / 20000);

    const MotionLaw::At start = frame.law.at(0), end = frame.law.at(1);
    const Eigen::AngleAxisd to_tank(-start.path, frame.law.axis), at_end(-end.path, frame.law.axis);
    const Vec3 rate = start.rate * frame.law.axis;
    of.velocity = to_tank * (of.velocity - rate.cross(of.mass.centre - frame.pivot));
    of.spin = to_tank * (of.spin - rate);
    of.mass.centre = in_tank(frame, of.mass.centre, 0);
    of.mass.inertia = to_tank.toRotationMatrix() * of.mass.inertia * to_tank.toRotationMatrix().transpose();
    RigidBody tank(of);
    for (int n = 0; n < steps; ++n) {
        tank.drift(dt / 2);
        const FrameForce f = frame.force(tank.state().time, Vec3::Zero());
        RigidBody middle = tank;
        const FrameLoad first = keep(load_on(middle, f));
        middle.kick(first.force, first.moment, dt / 2);
        const FrameLoad load = keep(load_on(middle, f));
        tank.kick(load.force, load.moment, dt);
        tank.drift(dt / 2);
    }
    const Eigen::Quaterniond seen =
        Eigen::Quaterniond(at_end) * earth.state().attitude * Eigen::Quaterniond(to_tank).conjugate();
    return (tank.state().centre - in_tank(frame, earth.state().centre, 1)).norm() +
           tank.state().attitude.angularDistance(seen);
}

TEST(MovingFrame, ABodyWithoutLoadsTumblesInATankAsInTheEarth) {
    const auto all = [](const FrameLoad& load) { return load; };
    const double coarse = error_of_a_tumbling_body(200, all), fine = error_of_a_tumbling_body(400, all);
    EXPECT_LT(fine, 1e-3);
    EXPECT_NEAR(coarse / fine, 4, 0.4) << "of second order";
    EXPECT_GT(error_of_a_tumbling_body(400, [](const FrameLoad& l) { return FrameLoad{l.force, Vec3::Zero()}; }), 0.1);
}

TEST(MovingFrame, WhatRestsInTheEarthMovesAgainstATankThatSways) {
    const MovingFrame frame{swaying(), Vec3::Zero()};
    const double e = 1e-6;
    const Vec3 seen = (in_tank(frame, Vec3::Zero(), e) - in_tank(frame, Vec3::Zero(), -e)) / (2 * e);
    EXPECT_LT((frame.velocity_of_rest() - seen).norm(), 1e-8);
    EXPECT_GT(seen.norm(), 1);
}

}  // namespace moving_frame_test
}  // namespace tw
