#include "structure/degrees_of_freedom.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace tw::structure {
namespace degrees_of_freedom_test {
const std::vector<Vec3> nodes{{0, 0, 0}, {1, 0, 0}, {1, 2, 0.5}, {0, 1, 0}};

TEST(DegreesOfFreedom, OfARigidPartCarryItsNodesAlong) {
    DegreesOfFreedom f(nodes, 6);
    f.clamp(std::array{0});
    RigidPart part;
    part.centre = Vec3(0.3, -0.2, 0.7);
    part.mass = 5;
    part.nodes = {1, 2};
    const int number = f.carry(part);
    const SparseMatrix T = f.basis();
    ASSERT_EQ(T.cols(), 6 + 6);  // the part and the free node 3

    const Vec3 shift(1, 2, 3), turn(0.1, -0.4, 0.2);
    Eigen::VectorXd q = Eigen::VectorXd::Zero(12);
    q.head<6>() << shift, turn;
    const Eigen::VectorXd u = T * q;
    for (const int n : part.nodes) {
        const Vec3 expected = shift + turn.cross(nodes[static_cast<std::size_t>(n)] - part.centre);
        EXPECT_LT((u.segment<3>(6 * n) - expected).norm(), 1e-14);
        EXPECT_LT((u.segment<3>(6 * n + 3) - turn).norm(), 1e-14);
    }
    EXPECT_EQ(u.segment<6>(0).norm(), 0);
    EXPECT_LT((u.segment<3>(f.first_of_part(number)) - shift).norm(), 1e-14);
}

TEST(DegreesOfFreedom, OfAHingedPartLeaveTheNodesRotationsFree) {
    DegreesOfFreedom f(nodes, 6);
    RigidPart part;
    part.mass = 1;
    part.nodes = {0, 1, 2, 3};
    part.hinged = true;
    part.held = {true, true, false, true, true, true};  // falls only
    f.carry(part);
    const SparseMatrix T = f.basis();
    EXPECT_EQ(T.cols(), 1 + 4 * 3);
    const Eigen::VectorXd u = T * Eigen::VectorXd::Unit(13, 0);
    for (int n = 0; n < 4; ++n) EXPECT_EQ(u[6 * n + 2], 1);
    EXPECT_EQ(u[0], 0);
}

/// A rigid motion's kinetic energy is that of all masses: 1/2 m v^2 + 1/2 I omega^2 about the common centre.
TEST(DegreesOfFreedom, MassOfNodesOnARigidPartIsThatOfTheWhole) {
    DegreesOfFreedom f(nodes, 6);
    RigidPart part;
    part.centre = Vec3(0.5, 0.5, 0);
    part.mass = 3;
    part.inertia = Vec3(0.1, 0.2, 0.3).asDiagonal();
    part.nodes = {0, 1, 2, 3};
    f.carry(part);
    Eigen::VectorXd lumped = Eigen::VectorXd::Zero(24);
    for (int n = 0; n < 4; ++n) lumped.segment<3>(6 * n).setConstant(0.5 + n);
    const SparseMatrix T = f.basis(), M = T.transpose() * f.mass(lumped) * T;
    const Eigen::MatrixXd m = M;
    EXPECT_NEAR(m(2, 2), 3 + 0.5 + 1.5 + 2.5 + 3.5, 1e-14);
    double I_zz = 0.3;
    for (int n = 0; n < 4; ++n)
        I_zz += (0.5 + n) * (nodes[static_cast<std::size_t>(n)] - part.centre).head<2>().squaredNorm();
    EXPECT_NEAR(m(5, 5), I_zz, 1e-14);
}

TEST(DegreesOfFreedom, RefuseWhatCannotBe) {
    const auto refuses = [](auto&& change) {
        DegreesOfFreedom f(nodes, 6);
        try {
            change(f);
            f.basis();
        } catch (const InputError&) { return true; }
        return false;
    };
    EXPECT_FALSE(refuses([](DegreesOfFreedom& f) { f.clamp(std::array{0}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.clamp(std::array{4}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.hold(std::array{0}, {6}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.clamp(std::array{0, 1, 2, 3}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.carry({.mass = 1, .nodes = {}}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.carry({.mass = 1, .nodes = {4}}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) { f.carry({.mass = -1, .nodes = {0}}); }));
    EXPECT_TRUE(refuses([](DegreesOfFreedom& f) {
        f.carry({.mass = 1, .nodes = {0}});
        f.carry({.mass = 1, .nodes = {1, 0}});
    }));
}

}  // namespace degrees_of_freedom_test
}  // namespace tw::structure
