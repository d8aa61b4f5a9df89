// What independent peaks say: quantiles, the highest third and numbers of events, with intervals that hold what they say.
#include "statistics/peak_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tw::test {
namespace peak_statistics_test {

/// Peaks of waves in a narrow spectrum: Rayleigh's, of scale 1.
std::vector<double> rayleigh(int n, std::mt19937& random) {
    std::vector<double> peaks;
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < n; ++i) peaks.push_back(std::sqrt(-2 * std::log(1 - uniform(random))));
    return peaks;
}
double rayleigh_quantile(double p) { return std::sqrt(-2 * std::log(1 - p)); }

TEST(PeakStatistics, GiveNoQuantileThatTheNumberOfPeaksCannotBound) {
    EXPECT_EQ(fewest_peaks_for(0.5), 6);
    EXPECT_EQ(fewest_peaks_for(0.9), 29);
    EXPECT_EQ(fewest_peaks_for(0.99), 299);
    std::mt19937 random(1);
    for (const auto& [p, n] : {std::pair(0.5, 6), {0.9, 29}, {0.99, 299}}) {
        EXPECT_FALSE(quantile_of_peaks(rayleigh(n - 1, random), p)) << p;
        EXPECT_TRUE(quantile_of_peaks(rayleigh(n, random), p)) << p;
    }
    EXPECT_FALSE(highest_third(rayleigh(8, random)));
}

TEST(PeakStatistics, BoundAMedianByTheRanksOfTheTables) {
    std::vector<double> ten, hundred;
    for (int i = 1; i <= 10; ++i) ten.push_back(11 - i);
    for (int i = 1; i <= 100; ++i) hundred.push_back(i);
    const auto median = quantile_of_peaks(ten, 0.5), of_many = quantile_of_peaks(hundred, 0.5);
    ASSERT_TRUE(median && of_many);
    EXPECT_EQ(median->value, 5.5);
    EXPECT_EQ(median->low, 2);  // the second and the ninth of ten hold it in 97.9 %, the third and the ninth in 93.5 %
    EXPECT_EQ(median->high, 9);
    EXPECT_EQ(of_many->low, 40);  // of a hundred 95.4 % from the 40th to the 60th
    EXPECT_EQ(of_many->high, 60);
    EXPECT_EQ(median->half_width(), 3.5);
}

TEST(PeakStatistics, IntervalsHoldTheTruthAsOftenAsTheySay) {
    std::mt19937 random(7);
    // the mean of the highest third of Rayleigh's: 2.0024 (Longuet-Higgins 1952: H_1/3 = 4.004 sqrt(m0), H = 2 a)
    constexpr int families = 1000, drawn = 200;  // from the latter alone samples are drawn
    int median = 0, ninety = 0, third = 0;
    for (int i = 0; i < families; ++i) {
        const std::vector<double> peaks = rayleigh(60, random);
        const auto within = [](const std::optional<PeakValue>& v, double truth) {
            return v && v->low <= truth && truth <= v->high;
        };
        median += within(quantile_of_peaks(peaks, 0.5), rayleigh_quantile(0.5));
        ninety += within(quantile_of_peaks(peaks, 0.9), rayleigh_quantile(0.9));
        if (i < drawn) third += within(highest_third(peaks), 2.0024);
    }
    EXPECT_GE(median, 0.93 * families);  // 95 % and more, +- 1.4 % of so many families
    EXPECT_GE(ninety, 0.93 * families);
    EXPECT_LE(median, 0.985 * families) << "wider than it has to be";
    EXPECT_GE(third, 0.88 * drawn);  // a bootstrap of twenty values: 93 %, +- 3.6 % of so many
    EXPECT_LE(third, 0.985 * drawn);
}

TEST(PeakStatistics, EventsHaveTheIntervalOfClopperAndPearson) {
    const PeakValue none = count_of_events(0, 20), some = count_of_events(5, 20), all = count_of_events(20, 20);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high / 20, 1 - std::pow(0.025, 1.0 / 20), 1e-9);  // 16.8 %
    EXPECT_NEAR(some.low / 20, 0.0866, 1e-4);                          // Clopper & Pearson 1934: 8.7 and 49.1 %
    EXPECT_NEAR(some.high / 20, 0.4910, 1e-4);
    EXPECT_EQ(all.high, 20);
    EXPECT_NEAR(all.low / 20, std::pow(0.025, 1.0 / 20), 1e-9);
}

}  // namespace peak_statistics_test
}  // namespace tw::test
