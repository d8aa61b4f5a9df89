#include "spray/load/small_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/errors.h"
#include "spray/load/repeats.h"

namespace tw::spray {
namespace small_face_test {

const Liquid water;
constexpr double face = 1e-3;

TEST(SmallFace, FeelsTheSpeedOfADropThatCoversItAndNotItsSize) {
    const double p = pressure_of_one(3, 2e-3, face, water);
    EXPECT_NEAR(p, 0.84 * 4 / std::numbers::pi * 1000 * 9, 1e-9 * p);
    EXPECT_NEAR(pressure_of_one(3, 4e-3, face, water), p, 1e-9 * p);
    EXPECT_NEAR(pressure_of_one(6, 4e-3, face, water), 4 * p, 1e-9 * p);
    // a drop of half the face's edge spreads its force over the face
    EXPECT_NEAR(pressure_of_one(3, 0.5e-3, face, water), 0.84 * 1000 * 9 / 4, 1e-9 * p);
}

/// Drops thrown at random on a large square, counted where they touch the small one.
TEST(SmallFace, IsTouchedAsOftenAsDropsAtRandomTouchIt) {
    std::mt19937_64 random(3);
    constexpr double extent = 0.01, d = 1.7e-3;
    std::uniform_real_distribution<double> place(-extent / 2, extent / 2);
    const int count = 400000;
    int touched = 0;
    for (int i = 0; i < count; ++i) {
        const double x = std::max(0.0, std::abs(place(random)) - face / 2),
                     y = std::max(0.0, std::abs(place(random)) - face / 2);
        touched += std::hypot(x, y) <= d / 2;
    }
    const std::vector<Arrival> one(1, {.normal_speed = 2, .diameter = d});
    const FaceHits hits = face_hits(one, extent, face, water);
    const double expected = static_cast<double>(touched) / count;
    EXPECT_NEAR(hits.touches, expected, 4 * std::sqrt(expected / count));
    EXPECT_NEAR(hits.chance, 1 - std::exp(-hits.touches), 1e-12);
}

TEST(SmallFace, GivesThePressuresByHowOftenTheyOccur) {
    std::vector<Arrival> arrivals;
    for (int i = 0; i < 100; ++i) arrivals.push_back({.normal_speed = 1.0 + i, .diameter = 2e-3});
    const FaceHits hits = face_hits(arrivals, 0.1, face, water);
    EXPECT_NEAR(hits.median, pressure_of_one(50, 2e-3, face, water), 0.03 * hits.median);
    EXPECT_NEAR(hits.high, pressure_of_one(95, 2e-3, face, water), 0.03 * hits.high);
    EXPECT_EQ(hits.largest, pressure_of_one(100, 2e-3, face, water));
    EXPECT_EQ(face_hits({}, 0.1, face, water).chance, 0);
}

/// The study's five at 30 cm [kPa]: it left the fourth out, which lies 1.74 standard deviations away.
TEST(Repeats, PautasCriterionLeavesNothingOutOfFive) {
    const std::vector<double> study{10.58, 9.812, 10.212, 7.473, 10.512};
    const Repeats r = repeats_of(study);
    EXPECT_NEAR(r.mean, 9.7178, 1e-12);
    EXPECT_NEAR(r.deviation, 1.291, 1e-4);
    EXPECT_NEAR(r.farthest, 1.74, 0.005);
    EXPECT_EQ(r.left_out, 0u);
    EXPECT_EQ(r.kept_mean, r.mean);
    EXPECT_NEAR(r.error, r.deviation / std::sqrt(5.0), 1e-12);
}

TEST(Repeats, OfTwentyOneThatIsFarOffIsLeftOut) {
    std::vector<double> values;
    for (int i = 0; i < 19; ++i) values.push_back(10 + 0.1 * (i % 3));
    values.push_back(50);
    const Repeats r = repeats_of(values);
    EXPECT_EQ(r.left_out, 1u);
    EXPECT_LT(r.kept_mean, 10.2);
    EXPECT_THROW(repeats_of(std::vector<double>{1}), InputError);
    EXPECT_THROW(repeats_of(std::vector<double>{1, std::nan("")}), InputError);
}

}  // namespace small_face_test
}  // namespace tw::spray
