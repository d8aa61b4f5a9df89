#include "structure/shell/skin.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>

#include "base/errors.h"
#include "plate.h"

namespace tw::structure {
namespace skin_test {

/// Part of a cylinder, so that normals differ.
Shell curved() {
    ShellMesh m = plate_mesh(1, 1, 8, 4);
    for (Vec3& p : m.nodes) p = Vec3(std::sin(p.x()), p.y(), std::cos(p.x()));
    return Shell(m, Laminate({{isotropic(1e9, 0.3, 1000), 0, 0.02}}));
}

Eigen::VectorXd some(int size, double phase) {
    Eigen::VectorXd v(size);
    for (int k = 0; k < size; ++k) v[k] = std::sin(phase + 1.7 * k * k);
    return v;
}

TEST(Skin, IsClosedOutwardAndAsThickAsItIsAskedToBe) {
    const Shell shell = curved();
    const Skin skin(shell, 0.05);
    Vec3 closed = Vec3::Zero();
    double volume = 0;
    for (int t = 0; t < static_cast<int>(skin.reference().triangles.size()); ++t) {
        closed += skin.reference().area_vector2(t) / 2;
        volume += skin.reference().area_vector2(t).dot(skin.reference().corner(t, 0)) / 6;
    }
    EXPECT_LT(closed.norm(), 1e-14);
    EXPECT_NEAR(volume, 0.05, 0.0005);  // an arc of 1 by 1, cut into chords
    EXPECT_THROW(Skin(shell, 0.01), InputError);
}

/// Whatever forces act and however the shell moves: force, moment and power are the same on both sides.
TEST(Skin, HandsForceMomentAndPowerOverWithoutLoss) {
    const Shell shell = curved();
    const Skin skin(shell, 0.05);
    const std::size_t points = skin.reference().points.size();
    const Eigen::VectorXd raw = some(3 * static_cast<int>(points), 0.3), v = some(shell.dofs(), 1.1);
    std::vector<Vec3> F(points);
    for (std::size_t k = 0; k < points; ++k) F[k] = raw.segment<3>(3 * static_cast<int>(k));
    const Eigen::VectorXd f = skin.load(F);
    const std::vector<Vec3> speed = skin.velocity(v);
    Vec3 force = Vec3::Zero(), moment = force, taken = force, taken_moment = force;
    double power = 0;
    for (std::size_t k = 0; k < points; ++k) {
        force += F[k];
        moment += skin.reference().points[k].cross(F[k]);
        power += F[k].dot(speed[k]);
    }
    for (int n = 0; 6 * n < shell.dofs(); ++n) {
        taken += f.segment<3>(6 * n);
        taken_moment +=
            shell.mesh().nodes[static_cast<std::size_t>(n)].cross(f.segment<3>(6 * n)) + f.segment<3>(6 * n + 3);
    }
    EXPECT_LT((force - taken).norm(), 1e-12);
    EXPECT_LT((moment - taken_moment).norm(), 1e-12);
    EXPECT_NEAR(power, f.dot(v), 1e-12 * std::abs(power));
    EXPECT_GT(std::abs(power), 0.1);
}

TEST(Skin, GoesWithTheShell) {
    const Shell shell = curved();
    const Skin skin(shell, 0.05);
    const Vec3 shift(1, -2, 0.5), turn(1e-3, -2e-3, 5e-4);
    Eigen::VectorXd u(shell.dofs());
    for (int n = 0; 6 * n < u.size(); ++n)
        u.segment<6>(6 * n) << shift + turn.cross(shell.mesh().nodes[static_cast<std::size_t>(n)]), turn;
    const Surface now = skin.now(u);
    for (std::size_t k = 0; k < now.points.size(); ++k) {
        const Vec3& X = skin.reference().points[k];
        EXPECT_LT((now.points[k] - (X + shift + turn.cross(X))).norm(), 1e-14);
    }
}

/// 2 m of water on a clamped plate of 1 m span and 50 mm, of any width (plane strain), with its own weight: a
/// published hydrostatic benchmark, (q L^4 / 384 D) = 6.86e-5 m, and shear deformation (q L^2 / 8 S) on top of it.
TEST(Skin, WaterOnAPlateBendsItAsTheFormula) {
    const double E = 67.5e9, nu = 0.34, h = 0.05, rho = 2700, g = 9.81, D = E * h * h * h / (12 * (1 - nu * nu));
    const double q = 1000 * g * 2 + rho * g * h, S = 5.0 / 6 * E / (2 * (1 + nu)) * h;
    const double bending = q / (384 * D), exact = bending + q / (8 * S);
    EXPECT_NEAR(bending, 6.8604382e-5, 1e-11);
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const Shell plate(plate_mesh(1, 0.1, 10 << k, 1), Laminate({{isotropic(E, nu, rho), 0, h}}));
        const Skin skin(plate, h);
        std::vector<double> pressure;
        for (int t = 0; t < static_cast<int>(skin.reference().triangles.size()); ++t)
            pressure.push_back(skin.reference().area_vector2(t).normalized().z() > 0.5 ? 1000 * g * 2 : 0);
        const Eigen::VectorXd load = skin.load(Skin::forces(skin.reference(), pressure)) + plate.weight(Vec3(0, 0, -g));
        DegreesOfFreedom f = supported(plate, "CFCF");
        std::vector<int> all;
        for (std::size_t n = 0; n < plate.mesh().nodes.size(); ++n) all.push_back(static_cast<int>(n));
        f.hold(all, {3});  // no bending across
        const Eigen::VectorXd u = solved(plate, f, load);
        error[k] = -u[6 * nearest_node(plate.mesh().nodes, Vec3(0.5, 0, 0)) + 2] / exact - 1;
    }
    std::printf(
        "water on a plate: %+.3f %% with 10, %+.3f %% with 20 elements along the span; shear is %.1f %% of it\n",
        100 * error[0], 100 * error[1], 100 * (1 - bending / exact));
    EXPECT_LT(std::abs(error[1]), 0.01);
    EXPECT_LT(std::abs(error[1]), 0.35 * std::abs(error[0]));
}

}  // namespace skin_test
}  // namespace tw::structure
