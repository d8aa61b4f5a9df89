#include "structure/solid/solid.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "structure/equilibrium.h"
#include "structure/generate.h"

namespace tw::structure {
namespace solid_test {

/// The equilibrium under a pressure on one surface, put on in `steps`.
Eigen::VectorXd pressed(const Solid& s, const DegreesOfFreedom& f, const std::string& surface, double pressure,
                        int steps) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(s.dofs());
    const SparseMatrix T = f.basis();
    for (int k = 1; k <= steps; ++k) {
        const double p = pressure * k / steps;
        u = equilibrium(u, T,
                        {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
                             return s.pressure_load(at, surface, p) - s.internal_force(at);
                         },
                         [&](const Eigen::VectorXd& at) -> SparseMatrix {
                             return s.tangent(at) - s.pressure_tangent(at, surface, p);
                         }},
                        1e-6 * s.pressure_load(u, surface, p).norm());
    }
    return u;
}

/// A quarter of a ring, radii 1 and 2, one element deep, in plane strain; pressed from inside.
Solid quarter_ring(int cells, const Hyperelastic& material) {
    return Solid(block_mesh({2 * cells, cells, 1},
                            [](const Vec3& p) {
                                const double angle = pi / 2 * (1 - p.x()), r = 1 + p.y();
                                return Vec3(r * std::cos(angle), r * std::sin(angle), 0.2 * p.z());
                            }),
                 {material});
}
DegreesOfFreedom plane_strain(const Solid& s) {
    DegreesOfFreedom f(s.mesh().nodes, 3);
    f.hold(s.mesh().sets.at("x_min"), {0});
    f.hold(s.mesh().sets.at("x_max"), {1});
    f.hold(s.mesh().sets.at("z_min"), {2});
    f.hold(s.mesh().sets.at("z_max"), {2});
    return f;
}
double inner_displacement(const Solid& s, const Eigen::VectorXd& u) {
    double sum = 0;
    const auto& inner = s.mesh().sets.at("y_min");
    for (const int n : inner) {
        const Vec3 &X = s.mesh().nodes[static_cast<std::size_t>(n)], d = u.segment<3>(3 * n);
        sum += d.head<2>().dot(X.head<2>());  // radius 1
    }
    return sum / static_cast<double>(inner.size());
}

/// Lame 1852, plane strain: u(a) = p (1 + nu) a / E ((1 - 2 nu) a^2 + b^2) / (b^2 - a^2).
TEST(Solid, NearlyIncompressibleCylinderUnderPressureDoesNotLock) {
    const double E = 1e6, nu = 0.4999, p = 1e-4 * E, exact = p * (1 + nu) / E * ((1 - 2 * nu) + 4) / 3;
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const Solid s = quarter_ring(4 << k, Hyperelastic::neo_hookean(E, nu, 1000));
        error[k] = inner_displacement(s, pressed(s, plane_strain(s), "y_min", p, 1)) / exact - 1;
    }
    std::printf("Lame, nu 0.4999: %+.3f %% on 8 x 4, %+.3f %% on 16 x 8, order %.2f\n", 100 * error[0], 100 * error[1],
                std::log2(error[0] / error[1]));
    EXPECT_LT(std::abs(error[1]), 0.01);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
    // The same element with the volume taken at each point locks; this is what the mean volume cures.
    const Solid locked = quarter_ring(8, Hyperelastic::saint_venant(E, nu, 1000));
    const double left = inner_displacement(locked, pressed(locked, plane_strain(locked), "y_min", p, 1)) / exact;
    std::printf("with the volume at each point: %.3f of the formula\n", left);
    EXPECT_LT(left, 0.7);
}

/// An incompressible tube in plane strain, blown up until its inner radius is `stretch` times the first: a ring at R
/// comes to r, r^2 = R^2 + (stretch^2 - 1) a^2, and Mooney-Rivlin gives (Green & Adkins 1970, 2.5 with W of plane
/// strain (C10 + C01)(lambda^2 + lambda^-2 - 2)) p = 2 (C10 + C01) [ln lambda - 1/(2 lambda^2)] from the outer to the
/// inner.
TEST(Solid, MooneyRivlinTubeInflatesAsItsFormula) {
    const double C10 = 3e5, C01 = 1e5, inner = 1.5, outer = std::sqrt((4 + inner * inner - 1) / 4);
    const auto g = [](double l) { return std::log(l) - 1 / (2 * l * l); };
    const double p = 2 * (C10 + C01) * (g(inner) - g(outer));
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const Solid s = quarter_ring(4 << k, Hyperelastic::mooney_rivlin(C10, C01, 2e9, 1000));
        error[k] = inner_displacement(s, pressed(s, plane_strain(s), "y_min", p, 8)) / (inner - 1) - 1;
    }
    std::printf("tube blown up by half: %+.3f %% on 8 x 4, %+.3f %% on 16 x 8, order %.2f\n", 100 * error[0],
                100 * error[1], std::log2(error[0] / error[1]));
    EXPECT_LT(std::abs(error[1]), 0.01);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
}

/// An eighth of a thick sphere: three quarters of cube faces, thrown outward.
Solid eighth_of_a_sphere(int cells, const Hyperelastic& material) {
    std::vector<SolidMesh> parts;
    for (int axis = 0; axis < 3; ++axis)
        parts.push_back(block_mesh({cells, cells, cells}, [&](const Vec3& p) {
            Vec3 to;
            to[axis] = 1;
            to[(axis + 1) % 3] = std::tan(pi / 4 * p.x());
            to[(axis + 2) % 3] = std::tan(pi / 4 * p.y());
            return Vec3((1 + p.z()) * to.normalized());
        }));
    return Solid(joined(parts, 1e-9), {material});
}

/// Green & Adkins 1970, 2.6: p = integral of W'(lambda) / (lambda^3 - 1) from the outer to the inner stretch,
/// W = C10 (2 lambda^2 + lambda^-4 - 3) + C01 (lambda^4 + 2 lambda^-2 - 3), r^3 = R^3 + (stretch^3 - 1) a^3.
TEST(Solid, MooneyRivlinSphereInflatesAsItsFormula) {
    const double C10 = 3e5, C01 = 1e5, inner = 1.3, outer = std::cbrt((8 + inner * inner * inner - 1) / 8);
    double p = 0;
    const int n = 2000;
    for (int k = 0; k < n; ++k) {
        const double l = outer + (inner - outer) * (k + 0.5) / n;
        p += (C10 * (4 * l - 4 * std::pow(l, -5)) + C01 * (4 * l * l * l - 4 * std::pow(l, -3))) / (l * l * l - 1) *
             (inner - outer) / n;
    }
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const Solid s = eighth_of_a_sphere(2 << k, Hyperelastic::mooney_rivlin(C10, C01, 2e9, 1000));
        DegreesOfFreedom f(s.mesh().nodes, 3);
        std::vector<int> inside;
        for (int node = 0; 3 * node < s.dofs(); ++node) {
            const Vec3& X = s.mesh().nodes[static_cast<std::size_t>(node)];
            for (int d = 0; d < 3; ++d)
                if (std::abs(X[d]) < 1e-9) f.hold(std::array{node}, {d});
            if (std::abs(X.norm() - 1) < 1e-9) inside.push_back(node);
        }
        const Eigen::VectorXd u = pressed(s, f, "z_min", p, 6);
        double radius = 0;
        for (const int node : inside)
            radius += (s.mesh().nodes[static_cast<std::size_t>(node)] + u.segment<3>(3 * node)).norm();
        error[k] = (radius / static_cast<double>(inside.size()) - 1) / (inner - 1) - 1;
    }
    std::printf("sphere blown up by 30 %%: %+.3f %% with 2, %+.3f %% with 4 elements through the wall, order %.2f\n",
                100 * error[0], 100 * error[1], std::log2(error[0] / error[1]));
    EXPECT_LT(std::abs(error[1]), 0.02);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
}

/// Euler-Bernoulli with Timoshenko's shear: w = P L^3 / (3 E I) + P L / (5/6 G A), for a bar 10 times as long as high.
TEST(Solid, CantileverBendsAsTheBeamOnFineEnoughCells) {
    const double E = 1e7, h = 0.1, P = 0.01, G = E / 2;  // nu = 0: no anticlastic bending
    const double exact = P / (3 * E * h * h * h * h / 12) + P / (5.0 / 6 * G * h * h);
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const int n = 4 << k;
        const Solid s(block_mesh({10 * n, 1, n}, [&](const Vec3& p) { return Vec3(p.x(), h * p.y(), h * p.z()); }),
                      {Hyperelastic::saint_venant(E, 0, 1000)});
        DegreesOfFreedom f(s.mesh().nodes, 3);
        f.hold(s.mesh().sets.at("x_min"), {0, 1, 2});
        Eigen::VectorXd load = Eigen::VectorXd::Zero(s.dofs());
        const auto& tip = s.mesh().sets.at("x_max");
        double area = 0;  // shares of the end face
        std::vector<double> share;
        for (const int node : tip) {
            const double z = s.mesh().nodes[static_cast<std::size_t>(node)].z();
            share.push_back(z < 1e-9 || z > h - 1e-9 ? 0.5 : 1);
            area += share.back();
        }
        for (std::size_t i = 0; i < tip.size(); ++i) load[3 * tip[i] + 2] = P * share[i] / area;
        const Eigen::VectorXd u =
            equilibrium(Eigen::VectorXd::Zero(s.dofs()), f.basis(),
                        {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd { return load - s.internal_force(at); },
                         [&](const Eigen::VectorXd& at) { return s.tangent(at); }},
                        1e-6 * P);
        error[k] = u[3 * tip.front() + 2] / exact - 1;
    }
    std::printf("cantilever: %+.2f %% with 4, %+.2f %% with 8 cells through the height, order %.2f\n", 100 * error[0],
                100 * error[1], std::log2(error[0] / error[1]));
    EXPECT_LT(std::abs(error[1]), 0.02);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
}

}  // namespace solid_test
}  // namespace tw::structure
