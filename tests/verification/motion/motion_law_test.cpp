#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/numbers.h"
#include "motion/motion_law.h"

namespace tw {
namespace motion_law_test {

/// Rate and acceleration are the derivatives of the path, by central differences.
void expect_derivatives(const MotionLaw& law, double t) {
    const double e = 1e-4;
    const auto low = law.at(t - e), now = law.at(t), high = law.at(t + e);
    EXPECT_NEAR(now.rate, (high.path - low.path) / (2 * e), 1e-6) << t;
    EXPECT_NEAR(now.acceleration, (high.rate - low.rate) / (2 * e), 1e-5) << t;
}

TEST(MotionLaw, GivesTheDerivativesOfItsPath) {
    const MotionLaw constant{.kind = MotionLaw::Kind::constant, .rate = 3};
    const MotionLaw ramp{.kind = MotionLaw::Kind::ramp, .rate = 2, .ramp = 0.5};
    const MotionLaw sinusoid{.kind = MotionLaw::Kind::sinusoid, .amplitude = 0.1, .period = 1.3, .phase = 0.4};
    const MotionLaw table{.kind = MotionLaw::Kind::table, .times = {0, 0.3, 0.5, 1.2}, .values = {0, 0.2, 0.1, 0.4}};
    for (const MotionLaw& law : {constant, ramp, sinusoid, table}) {
        EXPECT_NEAR(law.at(0).path, 0, 1e-15);
        for (const double t : {0.05, 0.21, 0.44, 0.77, 1.1}) expect_derivatives(law, t);
    }
    EXPECT_NEAR(ramp.at(0.5 + 1).path - ramp.at(0.5).path, 2, 1e-14);
    EXPECT_EQ(ramp.at(0).rate, 0);
}

TEST(MotionLaw, ASinusoidWithARampBeginsAtRestAndSwingsAboutWhereItBegan) {
    const MotionLaw law{
        .kind = MotionLaw::Kind::sinusoid, .turns = true, .ramp = 3, .amplitude = 0.1, .period = 1.3, .phase = 0.4};
    EXPECT_EQ(law.at(0).path, 0);
    EXPECT_EQ(law.at(0).rate, 0);
    double low = 0, high = 0;
    for (double t = 3; t < 3 + 1.3; t += 0.01) {
        low = std::min(low, law.at(t).path);
        high = std::max(high, law.at(t).path);
    }
    EXPECT_NEAR(high, 0.1, 1e-4);
    EXPECT_NEAR(low, -0.1, 1e-4);
    for (const double t : {0.05, 0.8, 2.1, 2.99, 4.4}) expect_derivatives(law, t);
    EXPECT_NEAR(law.at(3 - 1e-9).rate, law.at(3 + 1e-9).rate, 1e-7);
    for (double t = 0; t < 5; t += 0.01) EXPECT_LE(std::abs(law.at(t).rate), 1.001 * law.fastest()) << t;
}

TEST(MotionLaw, OfATableGoesThroughItsRowsSmoothlyAndRestsBeyondThem) {
    const MotionLaw law{.kind = MotionLaw::Kind::table, .times = {0, 0.3, 0.5, 1.2}, .values = {0.5, 0.2, 0.1, 0.4}};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(law.at(law.times[k]).path, law.values[k], 1e-15);
    for (const double t : {0.3, 0.5}) {  // the second derivative is continuous
        EXPECT_NEAR(law.at(t - 1e-9).acceleration, law.at(t + 1e-9).acceleration, 1e-6);
        EXPECT_GT(std::abs(law.at(t).acceleration), 0.1);
    }
    EXPECT_EQ(law.at(-1).path, 0.5);
    EXPECT_EQ(law.at(2).path, 0.4);
    EXPECT_EQ(law.at(2).rate, 0);
    EXPECT_NEAR(law.at(1.2 - 1e-9).rate, 0, 1e-7);
    EXPECT_GE(law.fastest(), std::abs(law.at(0.15).rate));
}

// Each place needs the knots around it alone: a million places of it would take hours otherwise.
TEST(MotionLaw, OfATableOfAHundredThousandRowsIsTheSmoothMotionThatTheyAreOf) {
    MotionLaw law{.kind = MotionLaw::Kind::table};
    const double w = 2 * pi / 100;
    for (int k = 0; k <= 100000; ++k)
        law.times.push_back(1e-3 * k), law.values.push_back(1 - std::cos(w * law.times.back()));
    EXPECT_NEAR(law.fastest(), w, 1e-9 * w);
    for (int k = 1; k < 100000; k += 997) {
        const double knot = law.times[static_cast<std::size_t>(k)];
        for (const double t : {knot, knot + 0.37e-3}) {
            EXPECT_NEAR(law.at(t).rate, w * std::sin(w * t), 1e-9 * w);
            EXPECT_NEAR(law.at(t).acceleration, w * w * std::cos(w * t), 1e-4 * w * w);
        }
        EXPECT_NEAR(law.at(knot * (1 - 1e-12)).acceleration, law.at(knot).acceleration, 1e-4 * w * w);
    }
}

TEST(MotionLaw, OfATableThatDoesNotRiseInTimeIsRefused) {
    const auto message = [](std::vector<double> times, std::vector<double> values) {
        MotionLaw law{.kind = MotionLaw::Kind::table, .times = std::move(times), .values = std::move(values)};
        try {
            law.check_table();
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string();
    };
    EXPECT_EQ(message({0, 1, 2}, {0, 0, 0}), "");
    EXPECT_EQ(message({0, 1, 1}, {0, 0, 0}), "row 2 is at 1 s and row 3 at 1 s; expected times that rise");
    EXPECT_EQ(message({0, 1, 0.5}, {0, 0, 0}), "row 2 is at 1 s and row 3 at 0.5 s; expected times that rise");
    EXPECT_EQ(message({0, 1}, {0}), "2 times and 1 values; expected one value for each time");
    EXPECT_EQ(message({0}, {0}), "a table of motion needs two rows or more");
}

}  // namespace motion_law_test
}  // namespace tw
