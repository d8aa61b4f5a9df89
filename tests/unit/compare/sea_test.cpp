// What gauges tell of a sum of waves: heights, peak, reflection over whole repeat periods, and focused crests.
#include "compare/metrics/sea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "compare/metrics/wave_analysis.h"
#include "statistics/chi_square.h"

namespace tw::test {
namespace sea_test {

using std::numbers::pi;

/// Waves at multiples of 1/24 Hz round 1 Hz on deep water, at three gauges, with a part coming back, sampled unevenly.
RunRecord record_of(const std::string& kind, double to, double reflection, double larger = 1) {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"state", "finished"}, {"sea", kind}};
    r.state = "finished";
    r.numbers = {
        {"sea_peak_period", 1}, {"sea_repeat_period", 24}, {"wave_direction", 1}, {"mean_from", 2}, {"duration", to}};
    std::vector<std::array<double, 4>> waves;
    if (kind == "bichromatic") {
        waves = {{22.0 / 24, 0, 0.02, 0.3}, {1, 0, 0.03, 1.1}};
        r.numbers["sea_repeat_period"] = 12;
    } else {
        for (int n = 16; n <= 36; ++n)
            waves.push_back({n / 24.0, 0, 0.01 * std::exp(-std::pow((n - 24) / 4.0, 2)), std::fmod(n * n * 0.7, 6.28)});
    }
    std::string text;
    for (auto& w : waves) {
        w[1] = 4 * pi * pi * w[0] * w[0] / 9.81;
        for (const double x : w) text += std::to_string(x) + " ";
        text += "\n";
    }
    r.attributes["sea_components"] = text;
    Table& table = r.table("height");
    for (double t = 0; t < to; t += 0.03 + 0.004 * std::sin(t * 50)) {
        const std::size_t row = table.append(t);
        for (const auto& [name, x] : {std::pair("a", -0.3), std::pair("b", 0.05), std::pair("c", 0.31)}) {
            double eta = 0.004;
            for (const auto& w : waves)
                eta += larger * w[2] *
                       (std::cos(w[1] * x - 2 * pi * w[0] * t + w[3]) +
                        reflection * std::cos(-w[1] * x - 2 * pi * w[0] * t + 2 * w[3]));
            table.set(row, name, "m", eta);
            r.numbers[std::string("height_x_") + name] = x;
        }
    }
    return r;
}
Comparison compared(const RunRecord& r) {
    Comparison c;
    c.sources = {r};
    c.names = {"sph"};
    add_sea(c);
    return c;
}

TEST(SeaMeasure, GivesHeightPeakAndReflectionOverWholeRepeatPeriods) {
    double variance = 0;
    for (int n = 16; n <= 36; ++n) variance += std::pow(0.01 * std::exp(-std::pow((n - 24) / 4.0, 2)), 2) / 2;
    const Comparison c = compared(record_of("jonswap", 27, 0));
    const Quantity* height = c.find("significant_height:b");
    ASSERT_TRUE(height && height->values[0].known);
    EXPECT_NEAR(height->values[0].value / (4 * std::sqrt(variance)), 1, 1e-3);
    EXPECT_FALSE(std::isfinite(height->values[0].half_width)) << "the same sea, whole: nothing was sampled";
    EXPECT_NEAR(c.find("peak_period:b")->values[0].value, 1, 5e-3);
    EXPECT_NEAR(c.find("crossing_height:b")->values[0].value / (4 * std::sqrt(variance)), 0.95, 0.1);
    EXPECT_NEAR(c.find("wave_reflection")->values[0].value, 0, 0.1);
    EXPECT_NEAR(compared(record_of("jonswap", 27, 0.05)).find("wave_reflection")->values[0].value, 5, 0.1);
    const auto reference = [&](const char* of) {
        return std::ranges::find(c.references, std::string(of), &Reference::quantity)->value;
    };
    EXPECT_NEAR(reference("significant_height:b"), 4 * std::sqrt(variance), 1e-6);
    EXPECT_NEAR(reference("peak_period:b"), c.find("peak_period:b")->values[0].value, 1e-3);
    EXPECT_NEAR(compared(record_of("jonswap", 27, 0, 0.9)).find("significant_height:b")->values[0].value /
                    height->values[0].value,
                0.9, 1e-3);
}

// Waves that run back against a stream are shorter than those that come with it, so lengths of still water tell nothing.
TEST(SeaMeasure, InAStreamGivesNoReflection) {
    RunRecord r = record_of("jonswap", 27, 0.05);
    ASSERT_TRUE(compared(r).find("wave_reflection"));
    r.numbers["speed"] = 0.6;
    const Comparison c = compared(r);
    EXPECT_FALSE(c.find("wave_reflection"));
    EXPECT_TRUE(c.find("significant_height:b"));
}

TEST(SeaMeasure, OfAShorterRecordItIsASample) {
    const Comparison c = compared(record_of("jonswap", 17, 0));
    const MeanValue& height = c.find("significant_height:b")->values[0];
    // seven lines of 1/24 Hz are four and a half in these 15 s, nine degrees of freedom: from 0.69 to 1.83
    EXPECT_NEAR(height.half_width / height.value, 0.57, 0.12);
    EXPECT_NEAR(c.find("peak_period:b")->values[0].value, 1, 0.1);
    EXPECT_FALSE(c.find("wave_reflection")->values[0].known);
}

TEST(SeaMeasure, KnowsHowWellARecordTellsASeaState) {
    EXPECT_NEAR(chi_square(10, 1.959964) / 20.483, 1, 3e-3);
    EXPECT_NEAR(chi_square(10, -1.959964) / 3.247, 1, 1e-2);
    EXPECT_NEAR(chi_square(60, 1.959964) / 83.298, 1, 1e-3);
    // eight lines as high as one another: 16 degrees of freedom
    std::vector<double> levels;
    for (int i = 0; i < 640; ++i) {
        double x = 0.1;
        for (int n = 6; n < 14; ++n) x += std::cos(2 * pi * n * i / 640 + n * n);
        levels.push_back(x);
    }
    const WaveSpectrum s = spectrum_of(levels, 20, 0.2, 1);
    EXPECT_NEAR(s.variance, 4, 1e-9);
    EXPECT_NEAR(s.degrees, 16, 1e-9);
    EXPECT_NEAR(s.low, std::sqrt(16 / 28.845), 2e-3);
    EXPECT_NEAR(s.high, std::sqrt(16 / 6.908), 1e-2);
}

TEST(SeaMeasure, CountsWavesBetweenUpCrossings) {
    std::vector<double> levels;
    for (int i = 0; i < 1000; ++i) levels.push_back(3 + (i < 500 ? 1 : 2) * std::sin(2 * pi * i / 100));
    const std::vector<double> heights = crossing_heights(levels);
    ASSERT_EQ(heights.size(), 8) << "what begins or ends within a wave is none";
    EXPECT_NEAR(heights.front(), 2, 1e-2);
    EXPECT_NEAR(heights.back(), 4, 1e-2);
}

TEST(SeaMeasure, GivesTheHeightsOfTwoWaves) {
    const Comparison c = compared(record_of("bichromatic", 40, 0));
    EXPECT_NEAR(c.find("first_wave:b")->values[0].value, 0.04, 1e-5);
    EXPECT_NEAR(c.find("second_wave:b")->values[0].value, 0.06, 1e-5);
    EXPECT_LT(c.find("second_wave:b")->values[0].half_width, 1e-4);
}

TEST(SeaMeasure, GivesAFocusedCrestBesideBothOrders) {
    RunRecord r = record_of("focused", 12, 0);
    r.numbers["sea_focus_time"] = 6;
    r.numbers["sea_crest_first_b"] = 0.05, r.numbers["sea_crest_time_first_b"] = 6;
    r.numbers["sea_crest_second_b"] = 0.056, r.numbers["sea_crest_time_second_b"] = 6;
    Table table;
    for (double t = 0; t < 12; t += 0.04) {
        const std::size_t row = table.append(t);
        table.set(row, "b", "m", 0.055 * std::cos(2 * pi * (t - 6.013)) * std::exp(-std::pow((t - 6.013) / 2, 2)));
    }
    r.tables["height"] = table;
    const Comparison c = compared(r);
    EXPECT_NEAR(c.find("focused_crest:b")->values[0].value, 0.055, 2e-5);
    EXPECT_NEAR(c.find("focused_crest_time:b")->values[0].value, 6.013, 1e-3);
    EXPECT_EQ(std::count_if(c.references.begin(), c.references.end(),
                            [](const Reference& of) { return of.quantity == "focused_crest:b"; }),
              2);
    EXPECT_FALSE(c.find("wave_reflection"));
}

TEST(SeaMeasure, IsAbsentWithoutASea) {
    RunRecord r = record_of("jonswap", 27, 0);
    r.attributes.erase("sea");
    EXPECT_TRUE(compared(r).quantities.empty());
}

}  // namespace sea_test
}  // namespace tw::test
