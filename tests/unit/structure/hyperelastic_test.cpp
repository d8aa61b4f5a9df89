#include "structure/solid/hyperelastic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tw::structure {
namespace hyperelastic_test {
using Eigen::Matrix3d;
const Hyperelastic materials[] = {Hyperelastic::mooney_rivlin(4e5, 1e5, 5e8, 1100),
                                  Hyperelastic::saint_venant(1e6, 0.4, 1000)};

Matrix3d some_strain() { return Matrix3d{{1.3, 0.2, -0.1}, {0.05, 0.8, 0.3}, {-0.2, 0.1, 1.1}}; }

TEST(Hyperelastic, StressIsTheDerivativeOfTheEnergyAndTangentThatOfTheStress) {
    const Matrix3d F = some_strain();
    const double e = 1e-6;
    for (const Hyperelastic& m : materials) {
        const Matrix3d P = m.stress(F);
        const Matrix9 A = m.tangent(F);
        for (int k = 0; k < 9; ++k) {
            Matrix3d up = F, down = F;
            up(k % 3, k / 3) += e;
            down(k % 3, k / 3) -= e;
            EXPECT_NEAR((m.energy(up) - m.energy(down)) / (2 * e), P(k % 3, k / 3), 1e-7 * P.norm());
            const Matrix3d dP = (m.stress(up) - m.stress(down)) / (2 * e);
            const Eigen::Map<const Eigen::Matrix<double, 9, 1>> numeric(dP.data());
            EXPECT_LT((numeric - A.col(k)).norm(), 1e-7 * A.norm());
        }
        EXPECT_LT((A - A.transpose()).norm(), 1e-12 * A.norm());
    }
}

TEST(Hyperelastic, DoesNotFeelATurnOfTheWorld) {
    const Matrix3d F = some_strain(), R = Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, -2, 0.5).normalized()).matrix();
    for (const Hyperelastic& m : materials) {
        EXPECT_NEAR(m.energy(R * F) / m.energy(F), 1, 1e-13);
        EXPECT_LT((m.stress(R * F) - R * m.stress(F)).norm(), 1e-12 * m.stress(F).norm());
        EXPECT_LT(m.stress(R).norm(), 1e-10 * m.tangent(R).norm());
    }
}

/// Incompressible, pulled to lambda along x (Mooney): P11 = 2 (lambda - lambda^-2) (C10 + C01 / lambda), once the
/// pressure has made the sides free.
TEST(Hyperelastic, MooneyRivlinPullsAsItsFormula) {
    const double lambda = 1.8, side = 1 / std::sqrt(lambda);
    const Matrix3d F = Eigen::Vector3d(lambda, side, side).asDiagonal();
    const Matrix3d P = materials[0].stress(F), G = cofactor(F);
    const double pressure = -P(1, 1) / G(1, 1);
    EXPECT_NEAR(P(0, 0) + pressure * G(0, 0), 2 * (lambda - 1 / (lambda * lambda)) * (4e5 + 1e5 / lambda), 1e-6);
}

TEST(Hyperelastic, AtSmallStrainIsHookesLaw) {
    const double E = 3e6, nu = 0.45, e = 1e-7;
    for (const Hyperelastic& m : {Hyperelastic::neo_hookean(E, nu, 1000), Hyperelastic::saint_venant(E, nu, 1000)}) {
        const Matrix3d F = Eigen::Vector3d(1 + e, 1 - nu * e, 1 - nu * e).asDiagonal();
        const Matrix3d P = m.stress(F) + m.volume_stress(F.determinant()) * cofactor(F);
        EXPECT_NEAR(P(0, 0) / (E * e), 1, 1e-5);
        EXPECT_NEAR(P(1, 1) / (E * e), 0, 1e-5);
    }
}

TEST(Hyperelastic, ThatNoMaterialIsIsNamed) {
    EXPECT_EQ(impossible(materials[0]), "");
    EXPECT_EQ(impossible(materials[1]), "");
    EXPECT_NE(impossible(Hyperelastic::neo_hookean(1e6, 0.5, 1000)).find("bulk"), std::string::npos);
    EXPECT_NE(impossible(Hyperelastic::saint_venant(1e6, 0.6, 1000)).find("bulk"), std::string::npos);
    EXPECT_NE(impossible(Hyperelastic::mooney_rivlin(-1e5, 2e5, 1e8, 1000)).find("C10"), std::string::npos);
    EXPECT_NE(impossible(Hyperelastic::mooney_rivlin(1e5, 0, 1e8, 0)).find("density"), std::string::npos);
    EXPECT_NE(impossible(Hyperelastic::mooney_rivlin(std::nan(""), 0, 1e8, 1000)).find("shear"), std::string::npos);
}

}  // namespace hyperelastic_test
}  // namespace tw::structure
