// Period and damping of bodies that swing freely in still water, from their records.
#include "compare/metrics/free_decay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace tw::test {
namespace free_decay_test {

using std::numbers::pi;

struct Record {
    std::vector<double> t, x;
};
Record sampled(const std::function<double(double)>& x, double to, double step = 0.013) {
    Record r;
    for (double t = 0; t < to; t += step * (1 + 0.3 * std::sin(7 * t))) r.t.push_back(t), r.x.push_back(x(t));
    return r;
}

TEST(FreeDecay, FindsPeriodAndDampingOfAnExactOne) {
    for (const double zeta : {0.02, 0.1, 0.25}) {
        const double omega0 = 2 * pi / 0.9, delta = zeta * omega0, omega = omega0 * std::sqrt(1 - zeta * zeta);
        // released at rest, 0.03 above where it floats, 0.2 m below still water
        const Record r = sampled(
            [&](double t) {
                return -0.2 + 0.03 * std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
            },
            9);
        const FreeDecay d = free_decay(r.t, r.x, 1e-4);
        ASSERT_TRUE(d.period.known) << zeta << " " << d.why_not;
        EXPECT_NEAR(d.period.value / (2 * pi / omega), 1, 1e-6) << zeta;
        EXPECT_NEAR(d.damping.value / zeta, 1, 1e-5);
        EXPECT_NEAR(d.level, -0.2, 1e-7);
        EXPECT_LT(d.period.half_width, 0.03 * d.period.value);
    }
}

TEST(FreeDecay, SaysHowFarOneExponentialIsFromTheRecord) {
    // damping by the square of the speed: successive swings lose less and less
    double z = 0.05, v = 0;
    Record r;
    for (int i = 0; i < 6000; ++i) {
        if (i % 10 == 0) r.t.push_back(i * 1e-3), r.x.push_back(z);
        v += 1e-3 * (-40 * z - 6 * v * std::abs(v));
        z += 1e-3 * v;
    }
    const FreeDecay d = free_decay(r.t, r.x, 1e-4);
    ASSERT_TRUE(d.damping.known) << d.why_not;
    EXPECT_NEAR(d.period.value, 2 * pi / std::sqrt(40), 0.02);
    EXPECT_GT(d.damping.half_width, 0.1 * d.damping.value);
}

TEST(FreeDecay, IsNoneWhereNothingSwingsToRest) {
    const auto why = [](const std::function<double(double)>& x) {
        const Record r = sampled(x, 6);
        const FreeDecay d = free_decay(r.t, r.x, 1e-4);
        EXPECT_FALSE(d.period.known || d.damping.known);
        return d.why_not;
    };
    EXPECT_NE(why([](double t) { return -0.4 * t * t; }).find("fewer than"), std::string::npos);
    EXPECT_NE(why([](double t) { return 0.03 * std::exp(-3 * t); }).find("fewer than"), std::string::npos);
    EXPECT_NE(why([](double t) { return 1e-6 * std::cos(6 * t); }).find("fewer than"), std::string::npos);
    EXPECT_NE(why([](double t) { return 0.03 * std::cos(6 * t) * std::exp(0.1 * t); }).find("dies out"),
              std::string::npos);
}

RunRecord bobbing(double speed) {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"state", "finished"}};
    r.state = "finished";
    r.numbers = {{"speed", speed}};
    Table& table = r.table("body_box");
    for (double t = 0; t < 6; t += 0.01) {
        const std::size_t row = table.append(t);
        const double turn = 0.1 * std::exp(-0.5 * t) * std::cos(9 * t);
        table.set(row, "z", "m", 0.02 * std::exp(-0.8 * t) * std::cos(7 * t));
        table.set(row, "q0", "-", std::cos(turn / 2));
        table.set(row, "qx", "-", 0);
        table.set(row, "qy", "-", std::sin(turn / 2));
    }
    return r;
}

TEST(FreeDecay, IsAMeasureOfBodiesInStillWater) {
    Comparison c;
    c.sources = {bobbing(0)};
    c.names = {"sph"};
    add_free_decay(c);
    ASSERT_EQ(c.quantities.size(), 4);  // it does not roll
    EXPECT_NEAR(c.find("heave_period:box")->values[0].value, 2 * pi / 7, 1e-6);
    EXPECT_NEAR(c.find("heave_damping:box")->values[0].value, 0.8 / std::hypot(0.8, 7), 1e-6);
    EXPECT_NEAR(c.find("pitch_period:box")->values[0].value, 2 * pi / 9, 1e-6);
    EXPECT_NEAR(c.find("pitch_damping:box")->values[0].value, 0.5 / std::hypot(0.5, 9), 1e-6);
    Comparison in_a_stream;
    in_a_stream.sources = {bobbing(2)};
    in_a_stream.names = {"sph"};
    add_free_decay(in_a_stream);
    EXPECT_TRUE(in_a_stream.quantities.empty());
}

}  // namespace free_decay_test
}  // namespace tw::test
