#include <gtest/gtest.h>

#include <cmath>

#include "compare/grid_study/cost.h"

namespace tw {
namespace cost_of_accuracy_test {

/// Levels of a method whose error is E h^p at a cost of T h^-q seconds, finest first.
std::vector<CostPoint> levels(double E, double p, double T, double q) {
    std::vector<CostPoint> points;
    for (const double h : {1.0, 1.4142, 2.0, 2.8284}) points.push_back({h, T * std::pow(h, -q), E * std::pow(h, p)});
    return points;
}

TEST(CostOfAccuracy, TheSlopeIsTheOrderOverTheCostsExponent) {
    const CostOfAccuracy c = cost_of_accuracy(levels(3, 2, 1000, 4));
    ASSERT_TRUE(c.known());
    EXPECT_NEAR(c.slope, 0.5, 1e-12);
    EXPECT_NEAR(c.price_of_halving(), 4, 1e-10);  // half the error: h/sqrt 2, so 4 times the time
    EXPECT_NEAR(c.seconds_for(3), 1000, 1e-7);
    EXPECT_NEAR(c.seconds_for(1.5), 4000, 1e-6);
    EXPECT_NEAR(c.uncertainty_after(16000), 0.75, 1e-10);
    EXPECT_TRUE(c.measured(500));
    EXPECT_FALSE(c.measured(4000));
}

TEST(CostOfAccuracy, TheCheaperMethodChangesWhereTheLinesCross) {
    // a: U = 10 (T/100)^-1/4, b: U = 1 (T/1000)^-1/2
    const CostOfAccuracy a = cost_of_accuracy(levels(10, 1, 100, 4)), b = cost_of_accuracy(levels(1, 2, 1000, 4));
    const double T = crossover_seconds(a, b);
    EXPECT_NEAR(a.uncertainty_after(T), b.uncertainty_after(T), 1e-9);
    EXPECT_LT(a.uncertainty_after(T / 10), b.uncertainty_after(T / 10));
    EXPECT_GT(a.uncertainty_after(T * 10), b.uncertainty_after(T * 10));
    EXPECT_TRUE(std::isnan(crossover_seconds(a, a)));
}

TEST(CostOfAccuracy, TimeThatBoughtNothingHasNoLine) {
    const CostOfAccuracy worse = cost_of_accuracy(levels(1, -1, 100, 4));
    EXPECT_FALSE(worse.known());
    EXPECT_NE(worse.why_not.find("no accuracy"), std::string::npos);
    EXPECT_TRUE(std::isnan(worse.seconds_for(0.1)));
    EXPECT_FALSE(cost_of_accuracy({{1, 10, 0.5}}).known());
    EXPECT_FALSE(cost_of_accuracy({{1, 10, 0.5}, {2, 5, std::nan("")}, {3, 2, 0}}).known());
}

}  // namespace cost_of_accuracy_test
}  // namespace tw
