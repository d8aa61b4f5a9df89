#include "structure/solid/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "base/errors.h"
#include "structure/generate.h"

namespace tw::structure {
namespace solid_test {
const Hyperelastic rubber = Hyperelastic::mooney_rivlin(4e5, 1e5, 5e8, 1100);

/// Two by two by two elements, the inner node and all others moved off their lattice.
Solid skewed_block(const Hyperelastic& material = rubber) {
    return Solid(block_mesh({2, 2, 2},
                            [](const Vec3& p) {
                                return Vec3(p.x() + 0.1 * p.y() * p.z(), 0.9 * p.y() + 0.08 * p.x() * p.x(),
                                            1.2 * p.z() - 0.1 * p.x() * p.y() + 0.05 * p.z() * p.y());
                            }),
                 {material});
}

Eigen::VectorXd moved(const Solid& s, const std::function<Vec3(const Vec3&)>& to) {
    Eigen::VectorXd u(s.dofs());
    for (int n = 0; 3 * n < s.dofs(); ++n) {
        const Vec3& X = s.mesh().nodes[static_cast<std::size_t>(n)];
        u.segment<3>(3 * n) = to(X) - X;
    }
    return u;
}

Eigen::VectorXd bent(const Solid& s) {
    return moved(s, [](const Vec3& X) {
        return Vec3(1.1 * X.x() + 0.1 * X.z() * X.z(), X.y() - 0.2 * X.x() * X.z(), 0.95 * X.z() + 0.1 * X.x() * X.y());
    });
}

TEST(Solid, IsNotStrainedByARigidMotionHoweverLarge) {
    const Solid s = skewed_block();
    const Eigen::Matrix3d R = Eigen::AngleAxisd(2.5, Vec3(1, 2, -1).normalized()).matrix();
    const Eigen::VectorXd u = moved(s, [&](const Vec3& X) { return Vec3(R * X + Vec3(3, -1, 2)); });
    EXPECT_LT(s.internal_force(u).norm(), 1e-13 * rubber.bulk);
    EXPECT_GT(s.internal_force(bent(s)).norm(), 1e-4 * rubber.bulk);
    EXPECT_NEAR(s.energy(u), 0, 1e-7);
}

/// Constant strain: the forces on the one inner node cancel, and the energy is that of the volume.
TEST(Solid, PassesThePatchTest) {
    const Eigen::Matrix3d F{{1.2, 0.1, 0}, {-0.1, 0.9, 0.2}, {0.1, 0, 1.05}};
    for (const Hyperelastic& m : {rubber, Hyperelastic::saint_venant(1e6, 0.3, 1000)}) {
        const Solid s = skewed_block(m);
        const Eigen::VectorXd f = s.internal_force(moved(s, [&](const Vec3& X) { return Vec3(F * X); }));
        const int inner = 13;  // of 3 x 3 x 3 nodes
        EXPECT_LT(f.segment<3>(3 * inner).norm(), 1e-12 * f.norm());
        EXPECT_GT(f.norm(), 0);
        double volume = 0;
        for (const Hexahedron& h : s.elements()) volume += h.volume();
        const double exact = volume * (m.energy(F) + m.volume_energy(F.determinant()));
        EXPECT_NEAR(s.energy(moved(s, [&](const Vec3& X) { return Vec3(F * X); })) / exact, 1, 1e-12);
    }
}

TEST(Solid, ForcesAreTheGradientOfTheEnergyAndTheTangentThatOfTheForces) {
    for (const Hyperelastic& m : {rubber, Hyperelastic::saint_venant(1e6, 0.3, 1000)}) {
        const Solid s = skewed_block(m);
        const Eigen::VectorXd u = bent(s);
        const Eigen::VectorXd d = Eigen::VectorXd::Random(u.size());
        const double e = 1e-6;
        const Eigen::VectorXd f = s.internal_force(u);
        EXPECT_NEAR((s.energy(u + e * d) - s.energy(u - e * d)) / (2 * e), f.dot(d), 1e-7 * f.norm() * d.norm());
        const Eigen::VectorXd df = (s.internal_force(u + e * d) - s.internal_force(u - e * d)) / (2 * e);
        const SparseMatrix K = s.tangent(u);
        EXPECT_LT((df - K * d).norm(), 1e-7 * df.norm());
        Vec3 sum = Vec3::Zero();
        for (int n = 0; 3 * n < s.dofs(); ++n) sum += f.segment<3>(3 * n);
        EXPECT_LT(sum.norm(), 1e-12 * f.norm());  // no force from nowhere
    }
}

TEST(Solid, PressureOnItsWholeSurfaceIsTheGradientOfItsVolume) {
    const Solid s = skewed_block();
    const Eigen::VectorXd u = bent(s);
    const char* faces[] = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
    const auto volume = [&](const Eigen::VectorXd& at) {
        double v = 0;
        for (std::size_t e = 0; e < s.elements().size(); ++e)
            v += s.elements()[e].volume_ratio(s.corners(at, e)) * s.elements()[e].volume();
        return v;
    };
    Eigen::VectorXd f = Eigen::VectorXd::Zero(u.size());
    const Eigen::VectorXd d = Eigen::VectorXd::Random(u.size());
    Eigen::VectorXd stiff = f, df = f;
    const double e = 1e-6, p = 1000;
    for (const char* face : faces) {
        f += s.pressure_load(u, face, p);
        df += (s.pressure_load(u + e * d, face, p) - s.pressure_load(u - e * d, face, p)) / (2 * e);
        stiff += s.pressure_tangent(u, face, p) * d;
    }
    EXPECT_NEAR(-p * (volume(u + e * d) - volume(u - e * d)) / (2 * e), f.dot(d), 1e-7 * f.norm() * d.norm());
    EXPECT_LT((df - stiff).norm(), 1e-7 * df.norm());
    EXPECT_THROW(s.pressure_load(u, "inside", p), InputError);
}

TEST(Solid, MassIsThatOfItsVolume) {
    const Solid s(block_mesh({3, 2, 4}, [](const Vec3& p) { return Vec3(2 * p.x(), p.y(), 0.5 * p.z()); }), {rubber});
    double mass = 0;
    for (int n = 0; 3 * n < s.dofs(); ++n) mass += s.mass()[3 * n];
    EXPECT_NEAR(mass, 1100, 1e-9);
}

TEST(Solid, ThatIsInvertedUnconnectedOrWithoutMaterialIsRefused) {
    const auto refusal = [](const std::function<void(SolidMesh&)>& spoil, Hyperelastic material = rubber) {
        SolidMesh m = block_mesh({2, 1, 1}, [](const Vec3& p) { return p; });
        spoil(m);
        try {
            Solid s(m, {material});
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string();
    };
    EXPECT_EQ(refusal([](SolidMesh&) {}), "");
    EXPECT_NE(refusal([](SolidMesh& m) { std::swap(m.hexahedra[1][0], m.hexahedra[1][1]); }).find("hexahedron 1: "),
              std::string::npos);
    EXPECT_NE(refusal([](SolidMesh& m) { m.nodes.emplace_back(9, 9, 9); }).find("node 12 belongs to no"),
              std::string::npos);
    EXPECT_NE(refusal([](SolidMesh& m) { m.material[1] = 1; }).find("hexahedron 1: material 1"), std::string::npos);
    EXPECT_NE(refusal([](SolidMesh& m) { m.hexahedra[0][3] = 40; }).find("node 40 does not exist"), std::string::npos);
    EXPECT_NE(refusal([](SolidMesh&) {}, Hyperelastic::neo_hookean(1e6, 0.5, 1)).find("bulk"), std::string::npos);
}

}  // namespace solid_test
}  // namespace tw::structure
