#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compare/uncertainty/triplet.h"
#include "tests/unit/compare/refinement_studies.h"

namespace tw {
namespace uncertainty_test {

// Celik et al. 2008, table 1, first column: printed 1.53, 6.1685, 2.2 %; more digits recomputed from the equations.
TEST(CelikGci, MonotoneExampleOfThePaper) {
    const CelikGci g = celik_gci(celik_monotone);
    ASSERT_TRUE(g.known) << g.why_not;
    EXPECT_EQ(g.convergence, Convergence::monotone);
    EXPECT_NEAR(g.p, 1.5340, 5e-5);
    EXPECT_NEAR(g.phi_ext, 6.16850, 5e-6);
    EXPECT_NEAR(100 * g.e_a, 1.5, 0.05);
    EXPECT_NEAR(100 * g.e_ext, 1.7, 0.05);
    EXPECT_NEAR(100 * g.GCI21, 2.1750, 5e-5);
    EXPECT_NEAR(100 * g.GCI32, 4.1129, 5e-5);
    EXPECT_NEAR(g.uncertainty, g.GCI21 * 6.063, 1e-12);
}

// The same table, third column: printed 1.51, 6.0269, 0.5 %. With s = +1 the equation has no solution here.
TEST(CelikGci, OscillatoryExampleOfThePaper) {
    const CelikGci g = celik_gci(plane_meshes({18000, 4500, 980}, {6.0042, 5.9624, 6.0909}));
    ASSERT_TRUE(g.known) << g.why_not;
    EXPECT_EQ(g.convergence, Convergence::oscillatory);
    EXPECT_NEAR(g.p, 1.5077, 5e-5);
    EXPECT_NEAR(g.phi_ext, 6.02687, 5e-6);
    EXPECT_NEAR(100 * g.GCI21, 0.4720, 5e-5);
}

// NASA's examination of grid convergence, program verify.f90.
TEST(CelikGci, ExampleOfNasa) {
    const CelikGci g = celik_gci(study({1, 2, 4}, {0.97050, 0.96854, 0.96178}));
    EXPECT_NEAR(g.p, 1.78617, 5e-6);
    EXPECT_NEAR(g.phi_ext, 0.97130, 5e-6);
    EXPECT_NEAR(100 * g.GCI21, 0.103083, 5e-7);
    EXPECT_NEAR(100 * g.GCI32, 0.356249, 5e-7);
    EXPECT_NEAR(g.asymptotic, 1, 0.01);
}

TEST(XingStern, FactorsOnCeliksExample) {
    const XingStern x = xing_stern(celik_monotone, 2);
    ASSERT_TRUE(x.known) << x.why_not;
    EXPECT_NEAR(x.P, 0.76698, 5e-6);
    EXPECT_NEAR(std::abs(x.delta_RE), 0.105496, 5e-7);
    EXPECT_NEAR(x.uncertainty, 0.189688, 5e-7);
    EXPECT_NEAR(1.25 * std::abs(x.delta_RE), 0.131869, 1e-6);
    EXPECT_NEAR(x.limit, 6.16850, 5e-6);
}

TEST(XingStern, TheFactorIsOnePointSixAtTheOrderOfTheSchemeFromBothSides) {
    EXPECT_NEAR(xing_stern(power({1, 2, 4}, 5, 0.1, 2), 2).factor, 1.6, 1e-9);
    EXPECT_NEAR(xing_stern(power({1, 2, 4}, 5, 0.1, 2.0001), 2).factor, 1.6, 1e-3);
    EXPECT_NEAR(xing_stern(power({1, 2, 4}, 5, 0.1, 1), 2).factor, 2.45 - 0.425, 1e-9);
    EXPECT_NEAR(xing_stern(power({1, 2, 4}, 5, 0.1, 3), 2).factor, 1.5 * 16.4 - 14.8, 1e-9);
    EXPECT_FALSE(xing_stern(study({1, 2, 4}, {1.01, 0.98, 1.04}), 2).known);  // no factor for alternating signs
}

TEST(Triplet, FindsTheOrderForAnyRatios) {
    for (const double p : {0.02, 0.5, 1.0, 1.5, 2.0, 4.0})
        for (const auto& h : {std::vector<double>{1, 2, 4}, {1, 1.1, 1.7}, {0.3, 0.7, 0.72}}) {
            const Triplet t = finest_triplet(power(h, 3, -0.2, p));
            EXPECT_EQ(t.convergence, Convergence::monotone);
            EXPECT_NEAR(t.p, p, 1e-7) << h[1] << " " << h[2];
        }
    // The fixed-point iteration of the paper runs away for {1, 1.1, 1.7}: r32 > r21^2.
}

TEST(Triplet, AValueThatGoesAsTheLogarithmOfTheSpacingIsTheBorderOfDivergence) {
    const std::vector<double> h{1, 2, 2.5};  // R = ln 2 / ln 1.25 = 3.1: "divergent" were the border at R = 1
    EXPECT_EQ(finest_triplet(power(h, 1, 0.1, 0.1)).convergence, Convergence::monotone);
    EXPECT_GT(finest_triplet(power(h, 1, 0.1, 0.1)).R, 1);
    EXPECT_EQ(finest_triplet(power(h, 1, 0.1, -0.1)).convergence, Convergence::divergent);
    EXPECT_EQ(finest_triplet(study(h, {std::log(1), std::log(2), std::log(2.5)})).convergence, Convergence::divergent);
}

TEST(Triplet, ClassesOfTheIttc) {
    const std::vector<double> h{1, 2, 4};
    EXPECT_EQ(finest_triplet(study(h, {1, 1.1, 1.4})).convergence, Convergence::monotone);           // R = 1/3
    EXPECT_EQ(finest_triplet(study(h, {1, 1.3, 1.4})).convergence, Convergence::divergent);          // R = 3
    EXPECT_EQ(finest_triplet(study(h, {1, 1.1, 0.8})).convergence, Convergence::oscillatory);        // R = -1/3
    EXPECT_EQ(finest_triplet(study(h, {1, 1.3, 1.2})).convergence, Convergence::divergent);          // R = -3
    EXPECT_EQ(finest_triplet(study(h, {1.1, 1.1, 1.2})).convergence, Convergence::unchanged);        // R = 0
    EXPECT_EQ(finest_triplet(study(h, {1.0, 1.1, 1.1})).convergence, Convergence::divergent);        // R infinite
    EXPECT_EQ(finest_triplet(study(h, {0.3, 0.1 + 0.2, 0.3})).convergence, Convergence::unchanged);  // rounding
}

}  // namespace uncertainty_test
}  // namespace tw
