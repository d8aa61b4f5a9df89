#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/numbers.h"
#include "structure/equilibrium.h"
#include "structure/generate.h"
#include "structure/shell/corotational.h"
#include "structure/time/nonlinear_alpha.h"

namespace tw::structure {
namespace large_rotation_test {
constexpr double E = 1e9, t = 0.01, width = 0.1, EI = E * width * t * t * t / 12;

/// A strip of length 1, without Poisson's ratio: a beam.
Shell strip(int cells) { return Shell(plate_mesh(1, width, cells, 1), Laminate({{isotropic(E, 0, 1000), 0, t}})); }

/// A warped, skewed element pair and a state of some strain.
Shell warped() {
    ShellMesh m = plate_mesh(1, 0.7, 2, 1);
    m.nodes[1] += Vec3(0.05, 0.03, 0.04);
    m.nodes[5] += Vec3(-0.02, 0.05, -0.03);
    const PlyMaterial ply{4e9, 1e9, 0.25, 0.4e9, 0.4e9, 0.3e9, 1500};
    return Shell(m, Laminate({{ply, 0.3, 0.02}, {ply, -0.7, 0.03}}));
}

TEST(LargeRotation, OfTheWholeShellStrainsNothing) {
    const Shell shell = warped();
    const Corotational turning(shell);
    for (const double angle : {0.3, 1.7, 3.0}) {
        const Vec3 axis = Vec3(0.3, -1, 0.6).normalized();
        const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
        Eigen::VectorXd u(shell.dofs());
        for (int n = 0; 6 * n < u.size(); ++n) {
            const Vec3& X = shell.mesh().nodes[static_cast<std::size_t>(n)];
            u.segment<3>(6 * n) = R * X + Vec3(1, 2, 3) - X;
            u.segment<3>(6 * n + 3) = angle * axis;
        }
        EXPECT_LT(turning.internal_force(u).norm(), 1e-12 * 4e9 * t) << angle;
        EXPECT_GT((shell.stiffness() * u).norm(), 1e-3 * 4e9 * t) << angle;  // which a linear shell would feel
    }
}

/// In a strained and turned state every element is in balance, and the forces are the gradient of the energy: exactly
/// where elements are flat, to the order of the warp times the strain else.
TEST(LargeRotation, ForcesAreBalancedAndTheGradientOfTheEnergy) {
    const Shell shell = strip(3);
    const Corotational turning(shell);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dofs()), wave = u;
    for (int n = 0; 6 * n < u.size(); ++n)
        for (int d = 0; d < 6; ++d) wave[6 * n + d] = (d < 3 ? 0.003 : 0.02) * std::sin(3.0 * n + 2.0 * d * d);
    const Vec3 axis = Vec3(0.3, -1, 0.6).normalized();
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1.2, axis).toRotationMatrix();
    for (int n = 0; 6 * n < u.size(); ++n) {
        const Vec3& X = shell.mesh().nodes[static_cast<std::size_t>(n)];
        u.segment<3>(6 * n) = R * X - X;
        u.segment<3>(6 * n + 3) = 1.2 * axis;
    }
    u = turning.moved(u, wave);
    const Eigen::VectorXd f = turning.internal_force(u);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (int n = 0; 6 * n < u.size(); ++n) {
        force += f.segment<3>(6 * n);
        moment += f.segment<3>(6 * n + 3) +
                  (shell.mesh().nodes[static_cast<std::size_t>(n)] + u.segment<3>(6 * n)).cross(f.segment<3>(6 * n));
    }
    EXPECT_LT(force.norm(), 1e-12 * f.norm());
    EXPECT_LT(moment.norm(), 1e-12 * f.norm());
    double worst = 0;
    for (int k = 0; k < u.size(); ++k) {
        const Eigen::VectorXd by = 1e-6 * Eigen::VectorXd::Unit(u.size(), k);
        const double slope = (turning.energy(turning.moved(u, by)) - turning.energy(turning.moved(u, -by))) / 2e-6;
        worst = std::max(worst, std::abs(slope - f[k]));
    }
    EXPECT_LT(worst, 1e-3 * f.cwiseAbs().maxCoeff());
}

/// A cantilever under a load that keeps its direction: the elastica (Bisshopp & Drucker 1945); P L^2 / EI, deflection
/// and shortening over L by elliptic integrals.
TEST(LargeRotation, OfACantileverIsTheElastica) {
    const double table[][3] = {{1, 0.301720774, 0.0564332363},
                               {2, 0.49345748, 0.160641721},
                               {3, 0.603253441, 0.254420185},
                               {5, 0.713791524, 0.387628361},
                               {10, 0.810609025, 0.554995598}};
    for (const int cells : {10, 20}) {
        const Shell shell = strip(cells);
        const Corotational turning(shell);
        DegreesOfFreedom f(shell.mesh().nodes, 6);
        f.clamp(shell.mesh().sets.at("x_min"));
        const SparseMatrix T = f.basis();
        Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dofs()), load = u;
        for (const auto& [p, deflection, shortening] : table) {
            for (const int n : shell.mesh().sets.at("x_max")) load[6 * n + 2] = p * EI / 2;
            u = equilibrium(
                u, T,
                {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd { return load - turning.internal_force(at); },
                 [&](const Eigen::VectorXd& at) { return turning.tangent(at); },
                 [&](const Eigen::VectorXd& at, const Eigen::VectorXd& by) { return turning.moved(at, by); }},
                1e-7 * p * EI);
            const int tip = shell.mesh().sets.at("x_max").front();
            std::printf("elastica, %d cells, P L^2/EI = %4.1f: deflection %+.3f %%, shortening %+.3f %%\n", cells, p,
                        100 * (u[6 * tip + 2] / deflection - 1), 100 * (-u[6 * tip] / shortening - 1));
            EXPECT_NEAR(u[6 * tip + 2] / deflection, 1, cells == 20 ? 0.003 : 0.01);
            EXPECT_NEAR(-u[6 * tip] / shortening, 1, cells == 20 ? 0.005 : 0.02);
        }
    }
}

/// A moment 2 pi EI / L rolls the strip up into a circle.
TEST(LargeRotation, ByAMomentRollsAStripUpIntoACircle) {
    const Shell shell = strip(20);
    const Corotational turning(shell);
    DegreesOfFreedom f(shell.mesh().nodes, 6);
    f.clamp(shell.mesh().sets.at("x_min"));
    const SparseMatrix T = f.basis();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dofs()), load = u;
    for (int k = 1; k <= 20; ++k) {
        for (const int n : shell.mesh().sets.at("x_max")) load[6 * n + 4] = -2 * pi * EI * k / 20 / 2;
        u = equilibrium(
            u, T,
            {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd { return load - turning.internal_force(at); },
             [&](const Eigen::VectorXd& at) { return turning.tangent(at); },
             [&](const Eigen::VectorXd& at, const Eigen::VectorXd& by) { return turning.moved(at, by); }},
            1e-7 * EI);
    }
    const int tip = shell.mesh().sets.at("x_max").front();
    std::printf("circle: the end comes to (%.5f, %.5f) of the length\n", 1 + u[6 * tip], u[6 * tip + 2]);
    EXPECT_NEAR(1 + u[6 * tip], 0, 0.01);
    EXPECT_NEAR(u[6 * tip + 2], 0, 0.01);
}

/// A strip between clamped ends that cannot come closer, under pressure: as it deflects by more than its thickness it
/// pulls. With the tension S, D w'''' - S w'' = q and S = E t / L times half the integral of w'^2 (Timoshenko &
/// Woinowsky-Krieger 1959, chapter 1). Returns the deflection of its middle.
double pulling_strip(double q, double D) {
    const auto parts = [&](double S) {
        const double k = std::sqrt(S / D), A = q / (2 * S * k * std::sinh(k / 2));
        double stretch = 0;  // half the integral of w'^2
        const int n = 4000;
        for (int i = 0; i < n; ++i) {
            const double x = (i + 0.5) / n - 0.5, slope = -q * x / S + A * k * std::sinh(k * x);
            stretch += slope * slope / 2 / n;
        }
        return std::pair{E * t * stretch, q / (8 * S) - A * (std::cosh(k / 2) - 1)};
    };
    double low = 1e-6 * D, high = 1e6 * D;
    for (int i = 0; i < 200; ++i) {
        const double S = std::sqrt(low * high);
        (parts(S).first > S ? low : high) = S;
    }
    return parts(low).second;
}

TEST(LargeRotation, OfAClampedStripPullsAsTheFormula) {
    const double D = E * t * t * t / 12;
    const Shell shell = strip(40);
    const Corotational turning(shell);
    DegreesOfFreedom f(shell.mesh().nodes, 6);
    f.clamp(shell.mesh().sets.at("x_min"));
    f.clamp(shell.mesh().sets.at("x_max"));
    const SparseMatrix T = f.basis();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dofs());
    for (const double share : {1.0, 4.0, 16.0}) {
        const double q = share * 384 * D * t;  // would bend it by `share` thicknesses, did it not pull
        const Eigen::VectorXd load = shell.pressure_load(Eigen::VectorXd::Constant(40, -q));
        u = equilibrium(
            u, T,
            {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd { return load - turning.internal_force(at); },
             [&](const Eigen::VectorXd& at) { return turning.tangent(at); },
             [&](const Eigen::VectorXd& at, const Eigen::VectorXd& by) { return turning.moved(at, by); }},
            1e-7 * load.norm());
        const double w = u[6 * 20 + 2], exact = pulling_strip(q, D);
        std::printf("clamped strip: linear %.0f t, formula %.4f t, found %+.2f %%\n", share, exact / t,
                    100 * (w / exact - 1));
        EXPECT_NEAR(w / exact, 1, 0.01);
        EXPECT_LT(exact, 0.9 * share * t);
    }
}

/// A clamped strip that is struck so hard that it swings through several thicknesses: its energy stays, and it comes
/// back sooner than the linear one, because it pulls.
TEST(LargeRotation, InTimeKeepsTheEnergyOfAStripThatPulls) {
    const Shell shell = strip(12);
    DegreesOfFreedom f(shell.mesh().nodes, 6);
    f.clamp(shell.mesh().sets.at("x_min"));
    f.clamp(shell.mesh().sets.at("x_max"));
    const double omega = 22.3733 * std::sqrt(E * t * t / 12 / 1000), dt = 2 * pi / omega / 200;
    NonlinearAlpha time(shell, f, dt);
    Eigen::VectorXd v = Eigen::VectorXd::Zero(shell.dofs());
    const Eigen::VectorXd none = v;
    for (int n = 0; 6 * n < v.size(); ++n) {
        const double x = shell.mesh().nodes[static_cast<std::size_t>(n)].x();
        v[6 * n + 2] = 4 * t * omega * std::pow(std::sin(pi * x), 2);  // linearly: 4 thicknesses
    }
    time.start(v, none);
    const double first = time.kinetic_energy();
    double farthest = 0, worst = 0, back = 0;
    int most = 0;
    for (int k = 1; k <= 2000; ++k) {
        most = std::max(most, time.step(none));
        const double w = time.displacement()[6 * 6 + 2];
        farthest = std::max(farthest, w);
        if (back == 0 && w < 0) back = k * dt;
        worst = std::max(worst, std::abs((time.kinetic_energy() + time.elastic_energy()) / first - 1));
    }
    std::printf("struck strip: %.2f t, back after %.3f of the linear half period, energy within %.1e, %d iterations\n",
                farthest / t, back * omega / pi, worst, most);
    EXPECT_GT(farthest, 1.5 * t);
    EXPECT_LT(farthest, 3.5 * t);
    EXPECT_LT(back * omega / pi, 0.8);
    EXPECT_LT(worst, 0.003);
}

}  // namespace large_rotation_test
}  // namespace tw::structure
