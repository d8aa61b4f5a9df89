#include "statistics/student_t.h"

#include <gtest/gtest.h>

#include <vector>

namespace student_t_test {

using namespace tw;

TEST(MeanOfIndependent, OfThreeValuesHasTheTableValueOfTwoDegrees) {
    const IndependentMean mean = mean_of_independent(std::vector{1.0, 2.0, 3.0});
    EXPECT_NEAR(mean.value, 2, 1e-15);
    EXPECT_NEAR(mean.half_width, 4.30265 / std::sqrt(3.0), 1e-5);  // t_95 of two degrees: 4.30265; s = 1
    EXPECT_TRUE(std::isnan(mean_of_independent(std::vector{1.0}).half_width));
}

TEST(MeanOfIndependent, OfComplexValuesOnALineIsThatOfTheirPlacesOnIt) {
    const std::vector<double> places{1, 2, 4, 4.5};
    std::vector<std::complex<double>> values;
    for (const double x : places) values.push_back({0.3 + 0.6 * x, 0.8 * x});
    const IndependentMean along = mean_of_independent(places);
    const IndependentComplexMean mean = mean_of_independent(values);
    EXPECT_NEAR(std::abs(mean.value - std::complex<double>(0.3 + 0.6 * along.value, 0.8 * along.value)), 0, 1e-14);
    EXPECT_NEAR(mean.half_width, along.half_width, 1e-13);
}

}  // namespace student_t_test
