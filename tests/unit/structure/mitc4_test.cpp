#include "structure/shell/mitc4.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <functional>

#include "base/errors.h"
#include "structure/shell/shell.h"

namespace tw::structure {
namespace mitc4_test {

Laminate unsymmetric() {
    const PlyMaterial ply{40e9, 10e9, 0.25, 4e9, 4e9, 3e9, 1500};
    return Laminate({{ply, 0.3, 1e-2}, {isotropic(5e9, 0.4, 1200), 0, 3e-2}, {ply, -1.1, 2e-2}});
}

/// Bathe & Dvorkin's patch of five elements, none a parallelogram.
ShellMesh patch() {
    ShellMesh m;
    m.nodes = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {2, 2, 0}, {8, 3, 0}, {8, 7, 0}, {4, 7, 0}};
    m.quads = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
    m.sets["rim"] = {0, 1, 2, 3};
    return m;
}

TEST(Mitc4, IsNotStrainedByRigidMotionHoweverItLiesAndIsWarped) {
    const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(1.3, 0.2, 0.1), Vec3(1.1, 1.4, -0.2), Vec3(-0.1, 0.9, 0.25)};
    const Mitc4 element(corners, Vec3(1, 0.5, 0.2));
    const auto K = element.stiffness(unsymmetric().stiffness());
    EXPECT_LT((K - K.transpose()).norm(), 1e-12 * K.norm());
    for (int motion = 0; motion < 6; ++motion) {
        Eigen::Matrix<double, 24, 1> d;
        const Vec3 unit = Vec3::Unit(motion % 3), none = Vec3::Zero();
        const Vec3 &shift = motion < 3 ? unit : none, &turn = motion < 3 ? none : unit;
        for (int i = 0; i < 4; ++i) {
            d.segment<3>(6 * i) = shift + turn.cross(corners[static_cast<std::size_t>(i)]);
            d.segment<3>(6 * i + 3) = turn;
        }
        EXPECT_LT((K * d).norm(), 1e-12 * K.norm() * d.norm()) << motion;
        EXPECT_LT((element.strains(0.3, -0.8) * d).norm(), 1e-13) << motion;
    }
    // Six motions without energy, and not one more: nothing is left unstiffened.
    const Eigen::SelfAdjointEigenSolver<Mitc4::Matrix24> solver(K);
    EXPECT_LT(solver.eigenvalues()[5], 1e-10 * solver.eigenvalues()[23]);
    EXPECT_GT(solver.eigenvalues()[6], 1e-8 * solver.eigenvalues()[23]);
}

/// The rim of the patch is given the displacements of a state of constant strain; the inner nodes find it.
void expect_patch(const std::function<Eigen::Matrix<double, 6, 1>(const Vec3&)>& exact, const Laminate& laminate,
                  double tolerance = 1e-10) {
    const Shell shell(patch(), laminate);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dofs()), wanted = u;
    for (int n = 0; n < 8; ++n) wanted.segment<6>(6 * n) = exact(shell.mesh().nodes[static_cast<std::size_t>(n)]);
    u.head<24>() = wanted.head<24>();  // the rim's nodes come first
    DegreesOfFreedom f(shell.mesh().nodes, 6);
    f.clamp(shell.mesh().sets.at("rim"));
    const SparseMatrix T = f.basis(), K = shell.stiffness(), reduced = T.transpose() * K * T;
    u += T * Eigen::SimplicialLDLT<SparseMatrix>(reduced).solve(T.transpose() * -(K * u));
    EXPECT_LT((u - wanted).norm(), tolerance * wanted.norm());
}

TEST(Mitc4, PassesThePatchTestOfStretching) {
    expect_patch(
        [](const Vec3& p) {
            Eigen::Matrix<double, 6, 1> d;
            d << 1e-3 * p.x() + 5e-4 * p.y(), -3e-4 * p.x() + 7e-4 * p.y(), 0, 0, 0, (-3e-4 - 5e-4) / 2;
            return d;
        },
        unsymmetric());
}

/// w = -(a x^2 + b y^2 + 2 c x y) / 2: constant curvature and no transverse shear. theta_y = -w,x, theta_x = w,y.
TEST(Mitc4, PassesThePatchTestOfBendingAndTwist) {
    const double a = 1e-3, b = -4e-4, c = 6e-4;
    expect_patch(
        [&](const Vec3& p) {
            Eigen::Matrix<double, 6, 1> d;
            const double w_x = -(a * p.x() + c * p.y()), w_y = -(b * p.y() + c * p.x());
            d << 0, 0, (p.x() * w_x + p.y() * w_y) / 2, w_y, -w_x, 0;
            return d;
        },
        unsymmetric());
}

/// A plate sheared across: w = g . x, no rotation. It is 100 times as thick as wide, so that bending costs 1e4 times as
/// much as shear and the state, which lacks the moments of a real plate, is the answer to about 1e-5.
TEST(Mitc4, PassesThePatchTestOfTransverseShear) {
    const Laminate thick({{isotropic(1e9, 0.3, 1000), 0, 1e3}});
    expect_patch(
        [&](const Vec3& p) {
            Eigen::Matrix<double, 6, 1> d;
            d << 0, 0, 1e-3 * p.x() - 2e-3 * p.y(), 0, 0, 0;
            return d;
        },
        thick, 2e-5);
}

TEST(Mitc4, WithoutAreaOrWithACornerTurnedInIsRefused) {
    const auto refusal = [](const std::array<Vec3, 4>& corners, const Vec3& along = Vec3::UnitX()) {
        try {
            Mitc4 element(corners, along);
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string();
    };
    EXPECT_EQ(refusal({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}), "");
    EXPECT_NE(refusal({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}).find("without area"),
              std::string::npos);
    EXPECT_NE(refusal({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.2, 0.2, 0), Vec3(0, 1, 0)}).find("corner 3"),
              std::string::npos);
    EXPECT_NE(refusal({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, Vec3::UnitZ()).find("across"),
              std::string::npos);
}

/// Pressure on a closed surface adds up to nothing, and on a plate to minus the area along the normal.
TEST(Shell, PressureAndWeightAddUp) {
    const Shell shell(patch(), unsymmetric());
    const Eigen::VectorXd f = shell.pressure_load(Eigen::VectorXd::Constant(5, 7));
    Vec3 sum = Vec3::Zero();
    for (int n = 0; n < 8; ++n) sum += f.segment<3>(6 * n);
    EXPECT_LT((sum - Vec3(0, 0, -700)).norm(), 1e-10);
    const Eigen::VectorXd w = shell.weight(Vec3(0, 0, -9.81));
    double weight = 0;
    for (int n = 0; n < 8; ++n) weight += w[6 * n + 2];
    EXPECT_NEAR(weight, -9.81 * (100 * shell.laminate().areal_mass()), 1e-9);
}

}  // namespace mitc4_test
}  // namespace tw::structure
