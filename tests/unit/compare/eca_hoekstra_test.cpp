#include <gtest/gtest.h>

#include <vector>

#include "compare/uncertainty/convergence.h"
#include "tests/unit/compare/refinement_studies.h"

namespace tw {
namespace uncertainty_test {

TEST(EcaHoekstra, ExactValuesGiveTheGridConvergenceIndex) {
    const EcaHoekstra e = eca_hoekstra(power(five, 1, 0.05, 1.5));
    ASSERT_TRUE(e.known) << e.why_not;
    EXPECT_NEAR(e.p, 1.5, 1e-9);
    EXPECT_NEAR(e.phi0, 1, 1e-10);
    EXPECT_NEAR(e.sigma, 0, 1e-10);
    EXPECT_NEAR(e.uncertainty, 0.0625, 1e-9);  // 1.25 times the error 0.05
    EXPECT_EQ(e.convergence, Convergence::monotone);
}

TEST(EcaHoekstra, ValuesWithALittleNoise) {
    const EcaHoekstra e = eca_hoekstra(noisy);
    EXPECT_EQ(e.fit, ErrorFit::free_order);
    EXPECT_NEAR(e.p, 1.5587, 5e-5);
    EXPECT_NEAR(e.phi0, 1.00419, 5e-6);
    EXPECT_NEAR(e.sigma, 0.001143, 5e-7);
    EXPECT_NEAR(e.uncertainty, 0.06022, 5e-6);
    EXPECT_EQ(e.Fs, 1.25);
}

TEST(EcaHoekstra, AnOrderAboveTwoFallsToTheSecondOrderFitWithFactorThree) {
    const EcaHoekstra e = eca_hoekstra(power(five, 1, 0.01, 3));
    EXPECT_EQ(e.fit, ErrorFit::second);
    EXPECT_EQ(e.Fs, 3);
    EXPECT_NEAR(e.p, 3, 1e-9);
    EXPECT_NEAR(e.uncertainty, 0.1088, 5e-5);
}

TEST(EcaHoekstra, AnOrderBelowOneHalfFallsToPolynomialsWithFactorThree) {
    const EcaHoekstra e = eca_hoekstra(power(five, 1, 0.05, 0.3));
    EXPECT_EQ(e.fit, ErrorFit::first_and_second);
    EXPECT_EQ(e.Fs, 3);
    EXPECT_NEAR(e.p, 0.3, 1e-9);
}

// Between 2 and 2.1 the fit is that of second order, and still trusted: Fs = 1.25.
TEST(EcaHoekstra, AnOrderJustAboveTwoKeepsTheSmallFactor) {
    const EcaHoekstra e = eca_hoekstra(power(five, 1, 0.05, 2.05));
    EXPECT_EQ(e.fit, ErrorFit::second);
    EXPECT_EQ(e.Fs, 1.25);
}

TEST(EcaHoekstra, ScatteredValuesGetABoundAndTheirClass) {
    const EcaHoekstra e = eca_hoekstra(study(five, {1.00, 1.02, 0.99, 1.03, 0.98}));
    ASSERT_TRUE(e.known) << e.why_not;
    EXPECT_EQ(e.convergence, Convergence::scattered);
    EXPECT_GT(e.sigma, e.data_range);
    EXPECT_NEAR(e.uncertainty, 0.193, 5e-4);
    EXPECT_FALSE(estimate(study(five, {1.00, 1.02, 0.99, 1.03, 0.98})).converged);
}

// The weights favour the fine levels: with an outlier on the coarsest level the fits differ, and that of smaller sigma
// is taken. With one on the finest it is the other.
TEST(EcaHoekstra, TheFitOfSmallerDeviationIsTaken) {
    std::vector<StudyLevel> coarse_off = power(five, 1, 0.05, 1), fine_off = coarse_off;
    coarse_off[4].value += 0.01;
    fine_off[0].value += 0.004;
    const EcaHoekstra coarse = eca_hoekstra(coarse_off), fine = eca_hoekstra(fine_off);
    ASSERT_EQ(coarse.fit, ErrorFit::free_order);
    ASSERT_EQ(fine.fit, ErrorFit::free_order);
    EXPECT_TRUE(coarse.weighted);
    EXPECT_FALSE(fine.weighted);
}

TEST(EcaHoekstra, FourLevelsOrNothing) {
    EXPECT_TRUE(eca_hoekstra(power({1, 2, 3, 4}, 1, 0.1, 1)).known);
    const EcaHoekstra e = eca_hoekstra(power({1, 2, 3}, 1, 0.1, 1));
    EXPECT_FALSE(e.known);
    EXPECT_NE(e.why_not.find("four sizes"), std::string::npos);
}

}  // namespace uncertainty_test
}  // namespace tw
