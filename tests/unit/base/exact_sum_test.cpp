// Sums that are the same in any order, see base/exact_sum.h.
#include "base/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tw {
namespace exact_sum_test {

/// Forces between 1e-9 and 1e9 N of either sign.
std::vector<double> forces() {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-9, 9), side(-1, 1);
    std::vector<double> values;
    for (int k = 0; k < 20000; ++k) values.push_back(std::copysign(std::pow(10.0, exponent(random)), side(random)));
    return values;
}

template <class Sum>
Sum sum_of(const std::vector<double>& values) {
    Sum sum{};
    for (const double v : values) sum += v;
    return sum;
}

TEST(ExactSum, IsTheSameInAnyOrderWhereADoubleIsNot) {
    std::vector<double> values = forces();
    const double exact = sum_of<ExactSum>(values).value(), plain = sum_of<double>(values);
    std::mt19937_64 random(1);
    int plain_differs = 0;
    for (int trial = 0; trial < 20; ++trial) {
        std::ranges::shuffle(values, random);
        EXPECT_EQ(sum_of<ExactSum>(values).value(), exact);
        plain_differs += sum_of<double>(values) != plain;
    }
    EXPECT_GT(plain_differs, 0);  // or the order is no test
}

TEST(ExactSum, IsTheSameHoweverItsPartsAreShared) {
    const std::vector<double> values = forces();
    const double whole = sum_of<ExactSum>(values).value();
    for (const std::size_t parts : {2u, 3u, 7u}) {
        std::vector<ExactSum> of_part(parts);
        for (std::size_t k = 0; k < values.size(); ++k) of_part[k % parts] += values[k];
        ExactSum sum;
        for (std::size_t p = parts; p-- > 0;) sum += of_part[p];
        EXPECT_EQ(sum.value(), whole);
    }
}

TEST(ExactSum, LosesNothingToCancellation) {
    ExactSum sum;
    for (const double v : {1e18, 0.1, -1e18}) sum += v;
    EXPECT_EQ(sum.value(), 0.1);
    ExactSum beyond;  // on the way it is too large, at the end it is not
    for (const double v : {4e18, 4e18, 4e18, -4e18, -4e18, 3.0}) beyond += v;
    EXPECT_EQ(beyond.value(), 4e18 + 3);
}

TEST(ExactSum, CutsAddendsToWholeMultiplesOf2ToTheMinus63) {
    constexpr double unit = 0x1p-63;
    EXPECT_EQ((ExactSum{} += 2.75 * unit).value(), 2 * unit);
    EXPECT_EQ((ExactSum{} += -2.75 * unit).value(), -2 * unit);
    EXPECT_EQ((ExactSum{} += 0.75 * unit).value(), 0);
    const double tiny = 1.234567e-12;  // as of a droplet's mass
    ExactSum sum;
    for (int k = 0; k < 1000; ++k) sum += tiny;
    EXPECT_NEAR(sum.value(), 1000 * tiny, 1000 * unit);
    EXPECT_EQ((ExactSum{} += 5e-4).value(), 5e-4);
    EXPECT_EQ((ExactSum{} += -1e9 / 3).value(), -1e9 / 3);
    EXPECT_EQ((ExactSum{} += -1.0 / 3).value(), -1.0 / 3);
    EXPECT_EQ((ExactSum{} += 0x1p61 / 3).value(), 0x1p61 / 3);
}

TEST(ExactSum, SaysWhatIsNoNumber) {
    EXPECT_TRUE(std::isnan((ExactSum{} += std::nan("")).value()));
    EXPECT_TRUE(std::isnan((ExactSum{} += HUGE_VAL).value()));
    EXPECT_TRUE(std::isnan((ExactSum{} += 5e18).value()));
    ExactSum of_parts, broken;
    broken += -HUGE_VAL;
    of_parts += broken;
    of_parts += 1.0;
    EXPECT_TRUE(std::isnan(of_parts.value()));
}

TEST(ExactSum, OfVectorsIsThatOfEachComponent) {
    ExactVectorSum sum, other;
    sum += Vec3(1e17, 0.25, -3);
    other += Vec3(-1e17, 0.5, 1);
    sum += other;
    EXPECT_EQ(sum.value(), Vec3(0, 0.75, -2));
}

}  // namespace exact_sum_test
}  // namespace tw
