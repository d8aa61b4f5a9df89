#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "compare/truth/validation.h"
#include "test_paths.h"
#include "tests/verification/uncertainty/coverage.h"

namespace tw::test {
namespace coverage_test {

const std::vector<Estimated>& manufactured() {
    static const std::vector<Estimated> all = estimate_all(manufactured_families(4, 20));
    return all;
}

// 95 % is meant; below 90 it would be too sure, at 99 and above of no use.
TEST(Coverage, TheHeadlineHoldsTheTruthIn90To99PercentOfTheManufacturedFamilies) {
    const Coverage c = coverage_of(manufactured(), estimators[0]);
    EXPECT_GT(c.families, 1000u);
    EXPECT_GT(c.share_given(), 90);
    EXPECT_GE(c.share_held(), 90);
    EXPECT_LT(c.share_held(), 99);
}

TEST(Coverage, AtEveryNoiseAndNumberOfSizes) {
    for (const double noise : {0.1, 0.3, 1.0, 3.0}) {
        const Coverage c =
            coverage_of(manufactured(), estimators[0], [&](const Estimated& e) { return e.family.noise == noise; });
        EXPECT_GE(c.share_held(), 90) << noise;
    }
    for (const std::size_t n : {3u, 4u, 5u, 6u, 8u}) {
        const Coverage c =
            coverage_of(manufactured(), estimators[0], [&](const Estimated& e) { return e.family.levels.size() == n; });
        EXPECT_GE(c.share_held(), 90) << n;
        EXPECT_LT(c.share_held(), 100) << n;
    }
}

// Noise of three times the finest error: the bound of Eca & Hoekstra is what made every page "not converged".
TEST(Coverage, WhereValuesScatterTheHeadlineIsHalfAsWideAsTheBoundOfEcaAndHoekstra) {
    const auto scatters = [](const Estimated& e) { return e.family.noise == 3 && e.family.levels.size() > 4; };
    const Coverage headline = coverage_of(manufactured(), estimators[0], scatters),
                   bound = coverage_of(manufactured(), estimators[1], scatters);
    EXPECT_LT(headline.median_width(), 0.5 * bound.median_width());
    EXPECT_GE(headline.share_held(), 90);
}

/// Median half width of families with those sizes whose noise is as large as the finest error, or three times.
double width_of_noisy(const std::vector<double>& sizes) {
    const std::vector<Estimated> all = estimate_all(manufactured_families(20, 5, {sizes}));
    const Coverage c = coverage_of(all, estimators[0], [](const Estimated& e) { return e.family.noise >= 1; });
    EXPECT_GE(c.share_held(), 90) << sizes.size();
    return c.median_width();
}

// What `twinwake ladder` fills in, and why it does not fill in fewer than four sizes.
TEST(Coverage, SizesFilledInBetweenTheCoarseOnesOfFourNarrowTheIntervalAndBesideThreeTheyDoNot) {
    const double r = std::sqrt(2.0), q = std::sqrt(r);
    EXPECT_LT(width_of_noisy({1, r, r * q, r * r, r * r * q, r * r * r}),
              0.8 * width_of_noisy({1, r, r * r, r * r * r}));
    const double three = width_of_noisy({1, r, r * r}), beside_three = width_of_noisy({1, r, r * q, r * r});
    EXPECT_GT(beside_three, three);
    EXPECT_LT(beside_three, 2 * three) << "two large terms that cancel within the sizes explain no scatter";
}

// Three values whose changes grow: refused where that is the sizes' doing, not where it is within their known noise.
TEST(Coverage, ValuesThatGrowApartWithinTheirKnownNoiseGetAnIntervalThatHolds) {
    const std::vector<std::vector<double>> three{{1, std::sqrt(2.0), 2}};
    const std::vector<Estimated> without = estimate_all(manufactured_families(200, 31, three)),
                                 with = estimate_all(manufactured_families(200, 31, three, true));
    std::vector<Estimated> freed;
    std::size_t refused = 0;
    for (std::size_t k = 0; k < with.size(); ++k) {
        if (std::isfinite(without[k].estimate.uncertainty)) continue;
        ++refused;
        if (std::isfinite(with[k].estimate.uncertainty)) freed.push_back(with[k]);
    }
    EXPECT_GT(freed.size(), 0.8 * static_cast<double>(refused));
    EXPECT_GT(refused, 500u);
    const Coverage c = coverage_of(freed, estimators[0]);
    EXPECT_GE(c.share_held(), 90);
}

// What a suite takes for values whose changes grow and are small beside the goal: three times their range.
TEST(Coverage, ThreeTimesTheRangeOfValuesThatGrowApartHoldsTheTruth) {
    const std::vector<std::vector<double>> three{{1, std::sqrt(2.0), 2}};
    std::size_t refused = 0, held = 0, held_by_one = 0;
    for (const Estimated& e : estimate_all(manufactured_families(200, 31, three))) {
        if (std::isfinite(e.estimate.uncertainty)) continue;
        const auto [low, high] = std::ranges::minmax(e.estimate.levels, {}, &StudyLevel::value);
        const double range = high.value - low.value;
        ++refused, held += holds_truth(e, factor_of_spread * range), held_by_one += holds_truth(e, range);
    }
    const double share = 100.0 * static_cast<double>(held) / static_cast<double>(refused),
                 by_one = 100.0 * static_cast<double>(held_by_one) / static_cast<double>(refused);
    std::printf("%zu families whose changes grow: %.1f %% within three times their range, %.1f %% within it\n", refused,
                share, by_one);
    EXPECT_GT(refused, 500u);
    EXPECT_GE(share, 90);
    EXPECT_LT(by_one, 90) << "or a factor of three is not needed";
}

// Solved by the project's own methods, answer known: three sizes or more.
TEST(Coverage, TheExactCasesAreHeldInNineOfTen) {
    const std::vector<Estimated> exact = estimate_all(exact_families(TWINWAKE_TEST_DATA "/exact_families.csv"));
    EXPECT_GE(exact.size(), 30u);
    const Coverage c = coverage_of(exact, estimators[0], [](const Estimated& e) { return e.family.levels.size() > 2; });
    EXPECT_GE(c.families, 20u);
    EXPECT_GE(c.share_held(), 90);
}

}  // namespace coverage_test
}  // namespace tw::test
