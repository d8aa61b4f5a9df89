#include "structure/laminate.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"

namespace tw::structure {
namespace laminate_test {
const PlyMaterial ply{40e9, 10e9, 0.25, 4e9, 4e9, 3e9, 1500};

std::string refusal(std::vector<Ply> stack) {
    try {
        Laminate l(std::move(stack));
    } catch (const InputError& e) { return e.what(); }
    return {};
}

/// By hand: d = 1 - nu12^2 E2/E1 = 0.984375, Q11 = 40/d, Q22 = 10/d, Q12 = 2.5/d GPa, Q66 = 4 GPa.
TEST(Laminate, OfOneLayerAlongIsItsPlaneStressStiffness) {
    const Laminate l({{ply, 0, 2e-3}});
    const double d = 0.984375;
    EXPECT_NEAR(l.A()(0, 0), 40e9 / d * 2e-3, 1e-3);
    EXPECT_NEAR(l.A()(0, 1), 2.5e9 / d * 2e-3, 1e-3);
    EXPECT_NEAR(l.D()(1, 1), 10e9 / d * 8e-9 / 12, 1e-9);
    EXPECT_NEAR(l.D()(2, 2), 4e9 * 8e-9 / 12, 1e-9);
    EXPECT_NEAR(l.S()(0, 0), 5.0 / 6 * 4e9 * 2e-3, 1e-3);
    EXPECT_NEAR(l.S()(1, 1), 5.0 / 6 * 3e9 * 2e-3, 1e-3);
    EXPECT_EQ(l.B().norm(), 0);
    EXPECT_DOUBLE_EQ(l.areal_mass(), 3);
    EXPECT_NEAR(l.rotary_inertia(), 1500 * 8e-9 / 12, 1e-15);
}

/// At 45 degrees, by hand: Qbar11 = (Q11 + Q22 + 2 Q12) / 4 + Q66, Qbar12 the same - 2 Q66,
/// Qbar16 = Qbar26 = (Q11 - Q22) / 4, Qbar66 = (Q11 + Q22 - 2 Q12) / 4.
TEST(Laminate, OfALayerAtFortyFiveDegreesCouplesStretchAndShear) {
    const Laminate l({{ply, 45 * degree, 1}});
    const double d = 0.984375, Q11 = 40e9 / d, Q22 = 10e9 / d, Q12 = 2.5e9 / d, Q66 = 4e9;
    const double first = (Q11 + Q22 + 2 * Q12) / 4;
    EXPECT_NEAR(l.A()(0, 0) / (first + Q66), 1, 1e-14);
    EXPECT_NEAR(l.A()(0, 1) / (first - Q66), 1, 1e-14);
    EXPECT_NEAR(l.A()(0, 2) / ((Q11 - Q22) / 4), 1, 1e-14);
    EXPECT_NEAR(l.A()(1, 2) / ((Q11 - Q22) / 4), 1, 1e-14);
    EXPECT_NEAR(l.A()(2, 2) / ((Q11 + Q22 - 2 * Q12) / 4), 1, 1e-14);
    EXPECT_NEAR(l.S()(0, 1) / (5.0 / 6 * (4e9 - 3e9) / 2), 1, 1e-14);
}

/// [0/90], each of thickness h: B11 = -B22 = (Q22 - Q11) h^2 / 2, by hand; all else of B is zero.
TEST(Laminate, OfTwoCrossedLayersCouplesStretchAndBending) {
    const double h = 1e-3, d = 0.984375;
    const Laminate l({{ply, 0, h}, {ply, 90 * degree, h}});
    EXPECT_NEAR(l.B()(0, 0) / ((10e9 - 40e9) / d * h * h / 2), 1, 1e-12);
    EXPECT_NEAR(l.B()(1, 1) / l.B()(0, 0), -1, 1e-12);
    EXPECT_NEAR(l.B()(0, 1) / l.B()(0, 0), 0, 1e-12);
    EXPECT_NEAR(l.A()(0, 0) / (50e9 / d * h), 1, 1e-12);
    EXPECT_NEAR(l.D()(0, 0) / (50e9 / d * h * h * h / 3), 1, 1e-12);
}

TEST(Laminate, ThatIsMirroredAboutItsMiddleHasNoCoupling) {
    const Laminate l({{ply, 30 * degree, 1e-3}, {ply, -10 * degree, 2e-3}, {ply, 30 * degree, 1e-3}});
    EXPECT_LT(l.B().norm(), 1e-12 * l.A().norm() * l.thickness());
    EXPECT_GT(std::abs(l.D()(0, 2)), 1e-3 * l.D()(0, 0));  // it does bend and twist together
}

/// The stresses of the layers add up to the section's forces and moments (Gauss points of each layer are exact).
TEST(Laminate, PlyStressesAddUpToTheSectionsForcesAndMoments) {
    const Laminate l({{ply, 20 * degree, 1e-3}, {isotropic(5e9, 0.4, 1200), 0, 3e-3}, {ply, -70 * degree, 2e-3}});
    Eigen::Matrix<double, 8, 1> strains;
    strains << 1e-3, -2e-3, 5e-4, 0.1, 0.3, -0.2, 2e-3, -1e-3;
    Eigen::Vector3d N = Eigen::Vector3d::Zero(), M = Eigen::Vector3d::Zero();
    double z0 = -l.thickness() / 2;
    for (std::size_t k = 0; k < 3; ++k) {
        const Ply& p = l.plies()[k];
        const double c = std::cos(p.angle), s = std::sin(p.angle);
        Eigen::Matrix3d back;  // stresses of the layer's axes to those of the laminate
        back << c * c, s * s, -2 * c * s, s * s, c * c, 2 * c * s, c * s, -c * s, c * c - s * s;
        for (const double height : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
            const Eigen::Vector3d stress = back * l.state(strains, static_cast<int>(k), height).stress;
            N += stress * p.thickness / 2;
            M += stress * p.thickness / 2 * (z0 + height * p.thickness);
        }
        z0 += p.thickness;
    }
    const Eigen::Matrix<double, 8, 1> expected = l.stiffness() * strains;
    EXPECT_LT((N - expected.segment<3>(0)).norm(), 1e-12 * N.norm());
    EXPECT_LT((M - expected.segment<3>(3)).norm(), 1e-12 * M.norm());
}

TEST(Laminate, WithoutLayersOrOfWhatNoMaterialIsIsRefused) {
    EXPECT_NE(refusal({}), "");
    EXPECT_EQ(refusal({{ply, 0, 1e-3}}), "");
    EXPECT_NE(refusal({{ply, 0, 1e-3}, {ply, 0, 0}}).find("layer 2: thickness 0 m"), std::string::npos);
    EXPECT_NE(refusal({{ply, 0, std::nan("")}}), "");
    EXPECT_NE(refusal({{isotropic(1e9, 0.5, 1000), 0, 1e-3}}).find("Poisson's ratio 0.5"), std::string::npos);
    EXPECT_NE(refusal({{isotropic(1e9, 0.3, 0), 0, 1e-3}}).find("density"), std::string::npos);
    PlyMaterial impossible_ply = ply;
    impossible_ply.nu12 = 2.1;  // sqrt(40 / 10) = 2
    EXPECT_NE(refusal({{impossible_ply, 0, 1e-3}}).find("nu12 = 2.1"), std::string::npos);
    impossible_ply.nu12 = 1.9;
    EXPECT_EQ(refusal({{impossible_ply, 0, 1e-3}}), "");
}

}  // namespace laminate_test
}  // namespace tw::structure
