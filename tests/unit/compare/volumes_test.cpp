// What is made of the water in a box: what came into it, and how fast.
#include "compare/metrics/volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "record/water_in_box.h"

namespace tw::test {
namespace volumes_test {

/// From 0.1 s on nothing comes in for 2 s, then in every period of 0.8 s what `of_period(n)` says [m2], poured in during
/// its first half; the water sways beside. Steps are no whole part of a period.
template <class OfPeriod>
RunRecord basin(double end, double step, OfPeriod of_period) {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"state", "finished"}};
    r.state = "finished";
    r.numbers = {{"wave_period", 0.8}, {"mean_from", 2}, {"duration", end}};
    Table& t = r.table(volume_table);
    for (int k = 0; 0.1 + k * step <= end + 1e-9; ++k) {
        const double time = 0.1 + k * step, phase = (time - 2) / 0.8;
        double volume = 0.05 + 1e-3 * std::sin(2 * std::numbers::pi * phase);
        for (int n = 0; n < phase; ++n) volume += of_period(n) * std::min(1.0, 2 * (phase - n));
        t.set(t.append(time), "behind", "m3/m", volume);
    }
    return r;
}

Comparison of(std::vector<RunRecord> sources) {
    Comparison c;
    c.sources = std::move(sources);
    c.names = {"sph", "fvm"};
    c.names.resize(c.sources.size());
    add_volumes(c);
    return c;
}

TEST(Volumes, RateIsTheMeanOfWholePeriodsWithTheirScatter) {
    const auto steady = [](int) { return 4e-3; };
    const auto uneven = [](int n) { return n % 2 == 0 ? 3e-3 : 5e-3; };
    const Comparison c = of({basin(8.5, 0.013, steady), basin(8.45, 0.01, uneven)});
    const Quantity* rate = c.find("volume_rate:behind");
    ASSERT_TRUE(rate);
    EXPECT_EQ(rate->unit, "m3/m/s");
    // the last eight whole periods before 8.45 s, that begin 0.05 s after the waves'
    EXPECT_NEAR(rate->values[0].value, 4e-3 / 0.8, 2e-6);
    EXPECT_LT(rate->values[0].half_width, 2e-5);
    EXPECT_NEAR(rate->values[1].value, 4e-3 / 0.8, 1e-5);
    // gains of 3.25, 4.75, ... mm2, standard deviation 0.80e-3 over sqrt(8), Student's 2.36
    EXPECT_NEAR(rate->values[1].half_width, 2.365 * 0.80e-3 / 0.8 / std::sqrt(8), 5e-5);
    EXPECT_TRUE(rate->judged_in_grid_study);
}

TEST(Volumes, GainIsOfTheTimeThatAllCoverAndTakesOffWhatLeaves) {
    const auto comes = [](int n) { return n < 4 ? 5e-3 : -2e-3; };
    const Comparison c = of({basin(6.8, 0.01, comes), basin(5.2, 0.01, comes)});
    const Quantity* gain = c.find("volume_gain:behind");
    ASSERT_TRUE(gain);
    for (const MeanValue& v : gain->values)
        EXPECT_NEAR(v.value, 4 * 5e-3 - 1e-3 * std::sin(2 * std::numbers::pi * -1.9 / 0.8), 2e-5);
    EXPECT_NEAR(of({basin(6.8, 0.01, comes)}).find("volume_gain:behind")->values[0].value,
                4 * 5e-3 - 2 * 2e-3 - 1e-3 * std::sin(2 * std::numbers::pi * -1.9 / 0.8), 2e-5);
}

TEST(Volumes, BehindAWallAreItsOvertoppingBesideEurOtop) {
    RunRecord r = basin(8.45, 0.01, [](int) { return 4e-3; });
    for (const auto& [name, value] : {std::pair{"wall_freeboard_behind", 0.06},
                                      {"wall_cot_slope_behind", 0.0},
                                      {"wall_depth_behind", 0.5},
                                      {"wall_width_behind", 0.5},
                                      {"wave_height", 0.1 / std::numbers::sqrt2},
                                      {"gravity", 9.81}})
        r.numbers[name] = value;
    const Comparison c = of({r});
    EXPECT_FALSE(c.find("volume_rate:behind"));
    const Quantity* q = c.find("overtopping:behind");
    ASSERT_TRUE(q);
    EXPECT_EQ(q->unit, "m3/m/s");
    EXPECT_NEAR(q->values[0].value, 4e-3 / 0.8 / 0.5, 1e-5) << "per metre of crest";
    ASSERT_EQ(c.references.size(), 1u);
    EXPECT_EQ(c.references[0].quantity, q->name);
    EXPECT_NEAR(c.references[0].value, std::sqrt(9.81 * 1e-3) * 0.047 * std::exp(-std::pow(2.35 * 0.6, 1.3)), 1e-5);
    EXPECT_FALSE(c.references[0].in_range) << "of irregular waves";
}

TEST(Volumes, OfARecordWithoutTheBoxOrTooShortAreNotKnown) {
    const auto steady = [](int) { return 4e-3; };
    RunRecord without = basin(8, 0.01, steady);
    without.tables.clear();
    const Comparison c = of({basin(3.9, 0.01, steady), without});
    EXPECT_FALSE(c.find("volume_rate:behind")->values[0].known) << "two whole periods";
    EXPECT_TRUE(c.find("volume_gain:behind")->values[0].known);
    EXPECT_FALSE(c.find("volume_gain:behind")->values[1].known);
    RunRecord calm = basin(8, 0.01, steady);
    calm.numbers.erase("wave_period");
    EXPECT_FALSE(of({calm}).find("volume_rate:behind"));
}

}  // namespace volumes_test
}  // namespace tw::test
