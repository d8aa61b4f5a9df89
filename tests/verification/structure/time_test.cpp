#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/errors.h"
#include "base/numbers.h"
#include "plate.h"
#include "structure/solid/solid.h"
#include "structure/time/central_difference.h"
#include "structure/time/generalised_alpha.h"

namespace tw::structure {
namespace time_test {

Laminate sheet() { return Laminate({{isotropic(7e10, 0.3, 2700), 0, 5e-3}}); }

TEST(AverageAcceleration, KeepsTheEnergyOfAPlateOverTenThousandSteps) {
    const Shell plate = square_plate(6, sheet());
    const DegreesOfFreedom f = supported(plate, "CCCC");
    const SparseMatrix K = plate.stiffness(), M = f.mass(plate.mass());
    GeneralisedAlpha time(K, M, f.basis(), 1e-4);
    Eigen::VectorXd v = Eigen::VectorXd::Zero(plate.dofs());
    v[6 * nearest_node(plate.mesh().nodes, Vec3(0.4, 0.6, 0)) + 2] = 1;  // a blow: all modes ring
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(plate.dofs());
    time.start(none, v, none);
    const double first = time.kinetic_energy();
    double worst = 0;
    for (int k = 0; k < 10000; ++k) {
        time.step(none);
        worst = std::max(worst, std::abs((time.kinetic_energy() + time.elastic_energy()) / first - 1));
    }
    std::printf("average acceleration: energy within %.1e over 1e4 steps\n", worst);
    EXPECT_LT(worst, 1e-3);
    EXPECT_GT(time.elastic_energy(), 0.01 * first);

    // With damping of fast modes the same blow loses energy, so that the scheme's factor is in use.
    GeneralisedAlpha damped(K, M, f.basis(), 1e-4, 0.5);
    damped.start(none, v, none);
    for (int k = 0; k < 1000; ++k) damped.step(none);
    EXPECT_LT(damped.kinetic_energy() + damped.elastic_energy(), 0.9 * first);
}

/// A mode swings with the frequency that the scheme gives it: tan(omega' dt / 2) = omega dt / 2.
TEST(AverageAcceleration, SwingsAModeWithTheFrequencyOfItsFormula) {
    const Shell plate = square_plate(6, sheet());
    const DegreesOfFreedom f = supported(plate, "CCCC");
    const SparseMatrix K = plate.stiffness(), M = f.mass(plate.mass()), T = f.basis();
    const Modes modes = lowest_modes(reduced(K, T), reduced(M, T), 1);
    const double omega = modes.omega[0], dt = 0.5 / omega, swings = 2 / dt * std::atan(omega * dt / 2);
    GeneralisedAlpha time(K, M, T, dt);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(plate.dofs());
    const Eigen::VectorXd shape = T * modes.shapes.col(0);
    time.start(shape, none, none);
    for (int k = 1; k <= 200; ++k) {
        time.step(none);
        const double share = time.displacement().dot(shape) / shape.squaredNorm();
        ASSERT_NEAR(share, std::cos(swings * k * dt), 1e-6) << k;
    }
    EXPECT_GT(std::abs(std::cos(swings * 200 * dt) - std::cos(omega * 200 * dt)), 0.1);  // or the formula is not seen
}

/// A state put back goes on to the same bits.
TEST(AverageAcceleration, GoesOnFromAStateToTheSameBits) {
    const Shell plate = square_plate(4, sheet());
    const DegreesOfFreedom f = supported(plate, "CFFF");
    const SparseMatrix K = plate.stiffness(), M = f.mass(plate.mass());
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(plate.dofs());
    const Eigen::VectorXd load = plate.pressure_load(Eigen::VectorXd::LinSpaced(16, 0, 1000));
    GeneralisedAlpha one(K, M, f.basis(), 1e-4), two(K, M, f.basis(), 1e-4);
    one.start(none, none, load);
    for (int k = 0; k < 20; ++k) one.step(load * k);
    two.set_state(one.state());
    for (int k = 20; k < 40; ++k) {
        one.step(load * k);
        two.step(load * k);
    }
    EXPECT_EQ(one.displacement(), two.displacement());
    EXPECT_GT(one.displacement().norm(), 0);
}

/// A plate whose frame hangs on a drop mass, all falling freely: it falls with g and is not strained. Then a force on
/// the plate alone moves the common centre of mass by Newton's law.
TEST(AverageAcceleration, PlateOnADropMassFallsUnstrainedAndKeepsMomentum) {
    const Shell plate = square_plate(6, sheet());
    DegreesOfFreedom f(plate.mesh().nodes, 6);
    const auto frame = f.carry({.centre = Vec3(0.5, 0.5, 0.2),
                                .mass = 20,
                                .inertia = Vec3(1, 1, 2).asDiagonal(),
                                .nodes = plate.mesh().sets.at("edges")});
    const SparseMatrix M = f.mass(plate.mass()), K = f.widened(plate.stiffness());

    const Eigen::VectorXd none = Eigen::VectorXd::Zero(f.all());
    Eigen::VectorXd weight = none, push = none;
    weight = f.widened(plate.weight(Vec3(0, 0, -9.81)));
    weight[f.first_of_part(frame) + 2] = -9.81 * 20;
    push[6 * nearest_node(plate.mesh().nodes, Vec3(0.5, 0.5, 0)) + 2] = 100;

    GeneralisedAlpha falls(K, M, f.basis(), 1e-3);
    falls.start(none, none, weight);
    for (int k = 0; k < 100; ++k) falls.step(weight);
    EXPECT_NEAR(falls.displacement()[f.first_of_part(frame) + 2], -9.81 / 2 * 0.1 * 0.1, 1e-9);
    EXPECT_LT(falls.elastic_energy(), 1e-9 * falls.kinetic_energy());

    GeneralisedAlpha pushed(K, M, f.basis(), 1e-3);
    pushed.start(none, none, push);
    for (int k = 0; k < 100; ++k) pushed.step(push);
    const Eigen::VectorXd p = M * pushed.velocity();
    double momentum = p[f.first_of_part(frame) + 2];
    for (int n = 0; 6 * n < plate.dofs(); ++n) momentum += p[6 * n + 2];
    EXPECT_NEAR(momentum, 100 * 0.1, 1e-8);
    EXPECT_GT(pushed.elastic_energy(), 1e-6);
}

/// A bar of rubber, stretched by a tenth and twisted, let go.
Solid bar() {
    return Solid(block_mesh({1, 1, 4}, [](const Vec3& p) { return Vec3(0.1 * p.x(), 0.1 * p.y(), 0.4 * p.z()); }),
                 {Hyperelastic::mooney_rivlin(3e5, 1e5, 5e7, 1100)});
}
DegreesOfFreedom held(const Solid& s) {
    DegreesOfFreedom f(s.mesh().nodes, 3);
    f.clamp(s.mesh().sets.at("z_min"));
    return f;
}

TEST(CentralDifference, KeepsTheEnergyOfSwingingRubberOverTenThousandSteps) {
    const Solid s = bar();
    const DegreesOfFreedom f = held(s);
    CentralDifference time(f.mass(s.mass()), f.basis(),
                           [&](const Eigen::VectorXd& u, double) -> Eigen::VectorXd { return -s.internal_force(u); });
    Eigen::VectorXd v = Eigen::VectorXd::Zero(s.dofs());
    for (int n = 0; 3 * n < s.dofs(); ++n) {
        const Vec3& X = s.mesh().nodes[static_cast<std::size_t>(n)];
        v.segment<3>(3 * n) = X.z() * Vec3(-10 * (X.y() - 0.05) + 2, 10 * (X.x() - 0.05), 4);
    }
    time.set_velocity(v);
    const double first = time.kinetic_energy(), dt = 0.5 * s.explicit_step(time.displacement());
    const auto energy = [&] { return time.kinetic_energy() + s.energy(time.displacement()); };
    double early = 0, late = 0, strained = 0;
    for (int k = 0; k < 10000; ++k) {
        time.advance(dt, dt);
        if (k < 1000) early += energy() / 1000;
        if (k >= 9000) late += energy() / 1000;
        strained = std::max(strained, s.energy(time.displacement()));
    }
    std::printf("central difference: energy %+.1e over 1e4 steps, %.1e of it in the first mean\n", late / early - 1,
                early / first - 1);
    EXPECT_LT(std::abs(late / early - 1), 1e-3);
    // At half the limit the energy of kick-drift-kick swings by (omega dt)^2 / 8 of each mode about its mean.
    EXPECT_LT(std::abs(early / first - 1), 5e-3);
    EXPECT_GT(strained, 0.5 * first);
}

/// The elements' limit holds for the whole, and does not waste more than a factor of two.
TEST(CentralDifference, StepLimitIsSafeAndNear) {
    const Solid s = bar();
    const DegreesOfFreedom f = held(s);
    const SparseMatrix T = f.basis();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(s.dofs());
    const Eigen::MatrixXd K = reduced(s.tangent(none), T), M = reduced(f.mass(s.mass()), T);
    const double highest =
        std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M).eigenvalues().maxCoeff());
    const double limit = s.explicit_step(none);
    std::printf("explicit limit: %.3f of the true one\n", limit * highest / 2);
    EXPECT_LE(limit, 2 / highest);
    EXPECT_GT(limit, 1 / highest);

    // Beyond the true limit the smallest disturbance grows until the run is ended.
    CentralDifference time(f.mass(s.mass()), T,
                           [&](const Eigen::VectorXd& u, double) -> Eigen::VectorXd { return -s.internal_force(u); });
    Eigen::VectorXd v = none;
    v[3 * 10] = 1e-6;
    time.set_velocity(v);
    EXPECT_THROW(time.advance(1000 * 2.1 / highest, 2.1 / highest), RunError);
    CentralDifference sound(f.mass(s.mass()), T,
                            [&](const Eigen::VectorXd& u, double) -> Eigen::VectorXd { return -s.internal_force(u); });
    sound.set_velocity(v);
    const double before = sound.kinetic_energy();
    EXPECT_EQ(sound.advance(1000 * limit, limit), 1000);
    EXPECT_LT(sound.kinetic_energy(), 10 * before);

    const Shell plate = square_plate(4, sheet());
    const DegreesOfFreedom free = supported(plate, "CFFF");
    const SparseMatrix B = free.basis();
    const Eigen::MatrixXd K_plate = reduced(plate.stiffness(), B), M_plate = reduced(free.mass(plate.mass()), B);
    const double plate_highest =
        std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K_plate, M_plate).eigenvalues().maxCoeff());
    EXPECT_LE(plate.explicit_step(), 2 / plate_highest);
}

/// A state put back goes on to the same bits.
TEST(CentralDifference, GoesOnFromAStateToTheSameBits) {
    const Solid s = bar();
    const DegreesOfFreedom f = held(s);
    const auto force = [&](const Eigen::VectorXd& u, double) -> Eigen::VectorXd { return -s.internal_force(u); };
    CentralDifference one(f.mass(s.mass()), f.basis(), force), two(f.mass(s.mass()), f.basis(), force);
    one.set_velocity(Eigen::VectorXd::LinSpaced(s.dofs(), 0, 0.1));
    const double dt = s.explicit_step(one.displacement()) / 2;
    one.advance(20 * dt, dt);
    two.set_state(one.state());
    one.advance(20 * dt, dt);
    two.advance(20 * dt, dt);
    EXPECT_EQ(one.displacement(), two.displacement());
    EXPECT_EQ(one.state().t, two.state().t);
}

}  // namespace time_test
}  // namespace tw::structure
