// Running trim, rise and porpoising of a hull that is free in a stream.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "compare/compare.h"
#include "compare/metrics/hull_motion.h"
#include "statistics/sustained_oscillation.h"
#include "record/hull_motion.h"

namespace tw {
namespace hull_motion_test {

constexpr double two_pi = 2 * std::numbers::pi;

struct Signal {
    double amplitude = 1, period = 0.4, growth = 0, noise = 0;  ///< growth: exponent [1/s]
};
/// 3 s of a mean of 5 with an oscillation, a row each 2 ms.
std::vector<double> times() {
    std::vector<double> t;
    for (int i = 1; i <= 1500; ++i) t.push_back(0.002 * i);
    return t;
}
std::vector<double> values(const Signal& s) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> v;
    for (const double t : times())
        v.push_back(5 + s.amplitude * std::exp(s.growth * t) * std::sin(two_pi * t / s.period) +
                    s.noise * normal(random));
    return v;
}

TEST(SustainedOscillation, HasThePeriodAndAmplitudeOfASine) {
    const auto found = sustained_oscillation(times(), values({.amplitude = 0.8, .noise = 0.02}), 0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->period, 0.4, 0.006);
    EXPECT_NEAR(found->amplitude, 0.8, 0.08);
    EXPECT_EQ(found->cycles, 6);
}

TEST(SustainedOscillation, IsOneThatGrowsAndNoneThatDiesOut) {
    EXPECT_TRUE(sustained_oscillation(times(), values({.growth = 0.5}), 0));
    // five per cent of the critical damping: exp(-0.05 w t)
    EXPECT_FALSE(sustained_oscillation(times(), values({.growth = -0.05 * two_pi / 0.4}), 0));
}

TEST(SustainedOscillation, IsNotNoiseNorATrendNorTooFewCycles) {
    EXPECT_FALSE(sustained_oscillation(times(), values({.period = 1.2}), 0)) << "two and a half cycles";
    EXPECT_FALSE(sustained_oscillation(times(), values({}), 1.5)) << "those before 1.5 s do not count";
    std::vector<double> trend;
    for (const double t : times()) trend.push_back(3 + 2 * t);
    EXPECT_FALSE(sustained_oscillation(times(), trend, 0));
    EXPECT_FALSE(sustained_oscillation(times(), std::vector<double>(1500, 5.0), 0));
    // the walk of a body pushed at random wanders without a period
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> walk;
    double at = 0;
    for (std::size_t i = 0; i < 1500; ++i) walk.push_back(at += normal(random));
    EXPECT_FALSE(sustained_oscillation(times(), walk, 0));
}

/// A hull that rests at z = 0.1 m, trim 1 deg and planes 30 mm higher at 4 deg, swinging by `amplitude` [deg].
RunRecord planing(const std::string& method, double amplitude) {
    RunRecord r;
    r.attributes = {{"method", method}, {"motion", "stream"}, {"scene_hash", "s"}, {"hull_hash", "h"}};
    r.numbers = {{"duration", 3}, {"gravity", 9.81},    {"density", 1000},           {"speed", 5},
                 {"length", 2},   {"beam", 0.5},        {"near_hull", 0.03},         {"mean_from", 0.5},
                 {"rest_z", 0.1}, {"rest_trim_deg", 1}, {"rest_transom_draft", 0.12}};
    r.state = "finished";
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0, 1);
    Table& t = r.table(hull_motion_table);
    for (const double time : times()) {
        t.time.push_back(time);
        const double swing = std::sin(two_pi * time / 0.4);
        t.column("trim", "deg").values.push_back(4 + amplitude * swing + 0.01 * normal(random));
        t.column("z", "m").values.push_back(0.13 + 0.01 * amplitude * swing + 1e-4 * normal(random));
        t.column("transom_draft", "m").values.push_back(0.15 + 1e-4 * normal(random));
    }
    return r;
}

TEST(HullMotion, IsMeasuredFromWhereTheHullFloatsAtRest) {
    const Comparison c = compare_records({planing("sph", 0), planing("fvm", 0)});
    ASSERT_TRUE(c.find("running_trim"));
    EXPECT_NEAR(c.find("running_trim")->values[0].value, 4, 0.01);
    EXPECT_NEAR(c.find("rise")->values[0].value, 0.03, 1e-4);
    EXPECT_NEAR(c.find("transom_sinkage")->values[1].value, 0.03, 1e-4);
    EXPECT_FALSE(c.find("porpoising_period")) << "it is steady";
}

TEST(HullMotion, PorpoisingIsNamedWithItsPeriodAndAmplitudes) {
    const Comparison c = compare_records({planing("sph", 1), planing("fvm", 0.1)});
    ASSERT_TRUE(c.find("porpoising_period"));
    EXPECT_NEAR(c.find("porpoising_period")->values[0].value, 0.4, 0.01);
    EXPECT_NEAR(c.find("porpoising_pitch")->values[0].value, 1, 0.05);
    EXPECT_NEAR(c.find("porpoising_heave")->values[0].value, 0.01, 1e-3);
    EXPECT_FALSE(c.find("porpoising_period")->values[1].known) << "a tenth of a degree is no porpoising";
    EXPECT_TRUE(std::ranges::any_of(c.banners, [](const std::string& b) {
        return b.starts_with("SPH: the hull porpoises") && b.find("means of that oscillation") != std::string::npos;
    }));
}

TEST(HullMotion, OfAHullThatDoesNotFloatHasNoRise) {
    RunRecord r = planing("sph", 0);
    r.numbers.erase("rest_z");
    const Comparison c = compare_records({r});
    EXPECT_FALSE(c.find("rise")->values[0].known);
    EXPECT_TRUE(c.find("running_trim")->values[0].known);
}

}  // namespace hull_motion_test
}  // namespace tw
