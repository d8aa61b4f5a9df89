#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "compare/uncertainty/convergence.h"
#include "tests/unit/compare/refinement_studies.h"

namespace tw {
namespace uncertainty_test {

/// Student's t of a straight line through three points by hand: the posterior of phi0 where one set has all weight.
TEST(TrendNoise, AStraightLineWithLittleNoiseIsExtrapolatedToItsEnd) {
    const TrendNoise t = trend_noise(study(five, {1.0501, 1.0624, 1.0751, 1.0999, 1.1251}), 2);  // 1 + 0.05 h +- 1e-4
    ASSERT_TRUE(t.known);
    EXPECT_NEAR(t.phi0, 1, 0.01);
    EXPECT_GT(t.trend, 0.99);
    EXPECT_NEAR(t.phi1, 1.05, 0.005);
    EXPECT_GT(t.uncertainty, 0.05);
    EXPECT_LT(t.uncertainty, 0.1);
}

TEST(TrendNoise, TheLiftsOfThePrismGetAnIntervalOfTheSizeOfTheirScatter) {
    std::vector<StudyLevel> levels;  // docs/decisions/024-hull-force-cured.md, SPH
    for (const auto& [per_beam, lift] : std::vector<std::pair<double, double>>{
             {12, 3347}, {14, 3249}, {16, 3261}, {18, 3353}, {20, 3280}, {24, 3359}, {28, 2974}, {40, 3134}})
        levels.push_back({1 / per_beam, lift});
    const Estimate e = estimate(levels);
    EXPECT_EQ(e.convergence, Convergence::scattered);
    EXPECT_LT(e.uncertainty, 0.11 * 3134);
    EXPECT_GT(e.uncertainty, 0.05 * 3134);
    EXPECT_GT(e.eca_hoekstra.uncertainty, 3 * e.uncertainty);
    EXPECT_NEAR(e.trend_noise.sigma, 130, 50);
    EXPECT_NE(verdict_sentence(e).find("the bound of Eca & Hoekstra is ± "), std::string::npos) << verdict_sentence(e);
}

TEST(TrendNoise, MoreSizesNarrowTheIntervalOfValuesThatScatter) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    double few = 0, many = 0;
    int given = 0;
    for (int k = 0; k < 100; ++k) {
        std::vector<StudyLevel> levels;
        for (const double h : {1.0, 1.19, 1.41, 1.68, 2.0, 2.38, 2.83, 3.36})
            levels.push_back({h, 1 + 0.03 * normal(random)});
        const double of_many = estimate(levels).uncertainty,
                     of_few = estimate({levels[0], levels[2], levels[4], levels[6]}).uncertainty;
        if (std::isnan(of_many + of_few)) continue;  // noise that looks like running away
        many += of_many, few += of_few, ++given;
    }
    EXPECT_GE(given, 80);
    EXPECT_LT(many, 0.7 * few);
}

TEST(TrendNoise, TheNoiseThatIsKnownIsALowerBoundOfTheScatter) {
    std::vector<StudyLevel> levels = study(five, {1, 1.0001, 1, 1.0001, 1});  // nearly equal by chance
    const double alone = estimate(levels).uncertainty;
    for (StudyLevel& l : levels) l.half_width = 0.0196;  // a standard error of 0.01
    const Estimate e = estimate(levels);
    EXPECT_LT(alone, 0.001);
    EXPECT_GT(e.uncertainty, 0.0196 / std::sqrt(5.0));
    EXPECT_NEAR(e.trend_noise.sigma, 0.01, 1e-6);
}

TEST(TrendNoise, TheUncertaintyOfTheLevelsFollowsTheTrendAndStaysWhereThereIsOnlyScatter) {
    const Estimate smooth = estimate(power({1, 1.41, 2, 2.83}, 1, 0.05, 2)),
                   scatter = estimate(study({1, 1.41, 2, 2.83}, {1.01, 0.98, 1.02, 0.99}));
    EXPECT_GT(smooth.uncertainties[3] / smooth.uncertainties[0], 3);
    EXPECT_LT(scatter.uncertainties[3] / scatter.uncertainties[0], 2);
}

}  // namespace uncertainty_test
}  // namespace tw
