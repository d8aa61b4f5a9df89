#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/numbers.h"
#include "motion/motion_law.h"
#include "motion/table_motion.h"

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

MotionLaw table_of(const std::vector<double>& times, double (*s)(double)) {
    MotionLaw law{.kind = MotionLaw::Kind::table, .times = times};
    for (const double t : times) law.values.push_back(s(t));
    return law;
}
std::vector<double> steps(double from, double to, int n) {
    std::vector<double> times;
    for (int k = 0; k <= n; ++k) times.push_back(from + (to - from) * k / n);
    return times;
}

// A tank lifted with 2 m/s2: forced to rest at its last row, the spline was accelerated by up to 350 m/s2 there.
TEST(MotionLaw, OfATableThatEndsWhileItMovesDoesNotRingBeforeItsEnd) {
    const MotionLaw lift = table_of(steps(0, 1.02, 51), [](double t) { return t * t; });
    for (double t = 0; t < 1.02; t += 1e-3) {
        EXPECT_NEAR(lift.at(t).acceleration, 2, 1e-8) << t;
        EXPECT_NEAR(lift.at(t).rate, 2 * t, 1e-10) << t;
    }
    EXPECT_NEAR(largest_acceleration(lift), 2, 1e-8);
    EXPECT_NEAR(lift.fastest(), 2.04, 1e-10);

    const MotionLaw swing = table_of(steps(0, 1.13, 60), [](double t) { return 1 - std::cos(2 * pi * t); });
    for (double t = 0; t < 1.13; t += 1e-3)
        EXPECT_NEAR(swing.at(t).acceleration, 4 * pi * pi * std::cos(2 * pi * t), 0.02 * 4 * pi * pi) << t;

    const MotionLaw uneven = table_of({0, 0.1, 0.15, 0.3, 0.34, 0.5}, [](double t) { return -3 * t * t; });
    for (double t = 0; t < 0.5; t += 0.01) EXPECT_NEAR(uneven.at(t).acceleration, -6, 1e-9) << t;
}

TEST(MotionLaw, OfATableThatEndsWhileItMovesKeepsItsLastVelocityBeyond) {
    const MotionLaw lift = table_of(steps(0, 1, 50), [](double t) { return t * t; });
    EXPECT_NEAR(lift.at(1.5).rate, 2, 1e-10);
    EXPECT_NEAR(lift.at(1.5).path, 2, 1e-10);
    EXPECT_EQ(lift.at(1.5).acceleration, 0);
    // A ramp that has come to its velocity, and one that has come to rest.
    const MotionLaw ramp = table_of(steps(0, 1, 100), [](double t) { return t < 0.5 ? t * t : t - 0.25; });
    EXPECT_NEAR(ramp.at(3).rate, 1, 1e-3);
    const MotionLaw stops = table_of(steps(0, 1, 100), [](double t) { return t - std::sin(2 * pi * t) / (2 * pi); });
    EXPECT_EQ(stops.at(3).path, 1);
    EXPECT_EQ(stops.at(3).rate, 0);
    EXPECT_NEAR(stops.at(0.995).acceleration, 2 * pi * std::sin(2 * pi * 0.995), 0.01);
}

// The same at the other end: a table of a constant velocity is that from its first row on, not 3 times as fast.
TEST(MotionLaw, OfATableThatBeginsWhileItMovesStartsImpulsively) {
    const MotionLaw fall = table_of(steps(0, 1, 40), [](double t) { return -0.5 * t; });
    for (double t = 0; t < 1.5; t += 0.01) EXPECT_NEAR(fall.at(t).rate, -0.5, 1e-12) << t;
    EXPECT_NEAR(fall.fastest(), 0.5, 1e-12);
    const MotionLaw late{.kind = MotionLaw::Kind::table, .times = {0.5, 0.6, 0.7}, .values = {0, 0.1, 0.2}};
    EXPECT_THROW(late.check_table(), InputError);
    const MotionLaw from_rest{.kind = MotionLaw::Kind::table, .times = {0.5, 0.6, 0.7}, .values = {0, 0.1, 0.4}};
    EXPECT_NO_THROW(from_rest.check_table());
    EXPECT_EQ(from_rest.at(0.2).rate, 0);
}

TEST(MotionLaw, TheLargestAccelerationOfEveryLawIsMetAndNotPassed) {
    for (const MotionLaw& law :
         {MotionLaw{.kind = MotionLaw::Kind::constant, .rate = 3},
          MotionLaw{.kind = MotionLaw::Kind::ramp, .rate = -2, .ramp = 0.5},
          MotionLaw{.kind = MotionLaw::Kind::sinusoid, .amplitude = 0.1, .period = 1.3, .phase = 0.4},
          MotionLaw{.kind = MotionLaw::Kind::sinusoid, .ramp = 3, .amplitude = 0.1, .period = 1.3, .phase = 0.4},
          MotionLaw{.kind = MotionLaw::Kind::table, .times = {0, 0.3, 0.5, 1.2}, .values = {0, 0.2, 0.1, 0.4}}}) {
        double seen = 0;
        for (double t = 0; t < 5; t += 1e-3) seen = std::max(seen, std::abs(law.at(t).acceleration));
        EXPECT_LE(seen, 1.001 * largest_acceleration(law));
        EXPECT_GE(seen, 0.98 * largest_acceleration(law));
    }
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
