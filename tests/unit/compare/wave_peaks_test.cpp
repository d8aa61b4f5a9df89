// Peaks of loads, pressures, levels and accelerations in waves, one a period, as statistics.
#include "compare/metrics/wave_peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compared_peaks.h"
#include "record/event_threshold.h"
#include "record/run_record.h"

namespace tw::test {
namespace wave_peaks_test {

using std::numbers::pi;

constexpr double T = 0.8, omega = 2 * pi / T;

RunRecord in_waves(double duration) {
    RunRecord r;
    r.attributes = {{"method", "fvm"}, {"state", "finished"}};
    r.state = "finished";
    r.numbers = {
        {"wave_period", T}, {"wave_length", 1}, {"wave_direction", 1}, {"mean_from", 2}, {"duration", duration}};
    return r;
}
double value(const Comparison& c, const std::string& name) {
    const Quantity* q = c.find(name);
    return q && q->values[0].known ? q->values[0].value : NAN;
}

/// A slam of 20 ms in every period, a triangle whose height rises by 10 Pa from period to period: 10, 20, ... from t =
/// 2 s.
RunRecord slammed(int periods) {
    RunRecord r = in_waves(2 + periods * T);
    r.numbers[event_threshold("pressure", "P1")] = 10.0 * periods - 25;
    Table& table = r.table("pressure");
    for (int i = 0; i <= std::lround((2 + periods * T) * 1000); ++i) {
        const double t = i * 1e-3, since = t - 2, n = std::floor(since / T + 1e-9);
        const double off = std::abs(since - n * T - 0.3) / 0.01;
        table.set(table.append(t), "P1", "Pa", t < 2 ? 0 : 10 * (n + 1) * std::max(0.0, 1 - off));
    }
    return r;
}

TEST(WavePeaks, AreOneAPeriodAndGiveOnlyWhatTheirNumberBounds) {
    const Comparison few = compared(slammed(7)), more = compared(slammed(30));
    const double share =
        0.87;  // of a triangle of 10 ms to either side its mean from 2 ms before its peak to 3 ms after it
    EXPECT_NEAR(value(few, "peak_mean:pressure:P1"), 40 * share, 0.1);
    EXPECT_NEAR(value(few, "peak_median:pressure:P1"), 40 * share, 0.1);
    const Quantity* median = few.find("peak_median:pressure:P1");
    ASSERT_TRUE(median);
    EXPECT_NEAR(median->values[0].half_width, 30 * share, 0.1) << "of seven peaks the first and the last bound it";
    EXPECT_FALSE(few.find("peak_p90:pressure:P1") || few.find("peak_third:pressure:P1"));
    EXPECT_NEAR(value(more, "peak_third:pressure:P1"), 255 * share, 0.3);  // 210 to 300
    EXPECT_NEAR(value(more, "peak_p90:pressure:P1"), (10 * (30 + 1.0 / 3) * 0.9 + 10.0 / 3) * share, 0.3);
    EXPECT_FALSE(more.find("peak_p99:pressure:P1"));
    EXPECT_TRUE(more.find("peak_p90:pressure:P1")->judged_in_grid_study);
}

TEST(WavePeaks, AboveAThresholdAreEvents) {
    const Comparison c = compared(slammed(30));  // of 280, 290 and 300 no mean over 5 ms is above 275
    EXPECT_EQ(value(c, "peak_events:pressure:P1"), 0);
    RunRecord r = slammed(30);
    r.numbers[event_threshold("pressure", "P1")] = 225 * 0.87;
    const Comparison lower = compared(r);
    EXPECT_EQ(value(lower, "peak_events:pressure:P1"), 8);  // 230 to 300
    EXPECT_NEAR(lower.find("peak_events:pressure:P1")->values[0].half_width, 30 * 0.4589 - 8,
                0.01);  // Clopper & Pearson
    r.numbers.erase(event_threshold("pressure", "P1"));
    EXPECT_FALSE(compared(r).find("peak_events:pressure:P1"));
}

TEST(WavePeaks, OfParticlesThatAreSoundAreNotJudged) {
    RunRecord r = slammed(7);
    r.attributes["method"] = "sph";
    Comparison c;
    c.sources = {r};
    c.names = {"sph"};
    c.sources[0].numbers["c0"] = 30, c.sources[0].numbers["near_hull"] = 0.1;  // sound crosses six particles in 20 ms
    add_wave_peaks(c);
    const Quantity* q = c.find("peak_mean:pressure:P1");
    ASSERT_TRUE(q);
    EXPECT_FALSE(q->values[0].not_resolved.empty());
    EXPECT_EQ(value(c, "peak_events:pressure:P1"), 0) << "sound is no slam";
    c.sources[0].numbers["near_hull"] = 1e-4;
    c.quantities.clear();
    add_wave_peaks(c);
    EXPECT_TRUE(c.find("peak_mean:pressure:P1")->values[0].not_resolved.empty());
}

/// A sea of two components, sampled evenly: crests of different heights, about one a second.
TEST(WavePeaks, OfASeaCountAPeakOnceThatLiesBetweenTwoPeriods) {
    RunRecord r;
    r.attributes = {{"method", "fvm"}, {"state", "finished"}, {"sea", "jonswap"}};
    r.numbers = {{"sea_peak_period", 1}, {"wave_direction", 1}, {"mean_from", 0}};
    Table& table = r.table("height");
    for (int i = 0; i <= 4000; ++i) {  // crests of 1 m at 0, 2, 4, ... s: always where a period ends; one lower between
        const double t = 0.01 * i;
        table.set(table.append(t), "G", "m", 0.75 * std::cos(2 * pi * t) + 0.25 * std::cos(pi * t));
    }
    const Comparison c = compared(r);
    // of 40 periods half of the crests of 1 m are counted by both sides, unless each is counted once
    const Quantity* median = c.find("peak_median:height:G");
    ASSERT_TRUE(median);
    EXPECT_NE(median->definition.find("of 21 peaks"), std::string::npos) << median->definition;
    EXPECT_NEAR(median->values[0].value, 1, 1e-3);
    r.attributes["sea"] = "focused";
    EXPECT_TRUE(compared(r).quantities.empty()) << "one event has no statistics";
}

TEST(WavePeaks, OfALevelInRegularWavesCountWhereADeckIsGiven) {
    RunRecord r = in_waves(10);
    Table& table = r.table("height");
    for (int i = 0; i <= 500; ++i) {
        const double t = 0.02 * i, more = std::floor((t - 2) / T) >= 8 ? 1.2 : 1;  // the last two come higher
        table.set(table.append(t), "G", "m", 0.1 + more * 0.02 * std::cos(omega * (t - 2 - T / 2)));
    }
    EXPECT_FALSE(compared(r).find("peak_mean:height:G")) << "it has its crest by the harmonics";
    r.numbers[event_threshold("height", "G")] = 0.122;
    EXPECT_EQ(value(compared(r), "peak_events:height:G"), 2);
}

TEST(WavePeaks, OfLoadsAreAlongTheWavesWay) {
    RunRecord r = in_waves(10);
    Table& forces = r.table("forces");
    for (int i = 0; i <= 10000; ++i) {
        const double t = 0.001 * i;
        const std::size_t row = forces.append(t);
        forces.set(row, "fx", "N", -4 + 12 * std::cos(omega * t));
        forces.set(row, "fz", "N", 0);
    }
    EXPECT_NEAR(value(compared(r), "peak_mean:force_x"), 8, 0.01);
    r.numbers["wave_direction"] = -1;
    EXPECT_NEAR(value(compared(r), "peak_mean:force_x"), 16, 0.01);
    EXPECT_FALSE(compared(r).find("peak_mean:force_z")) << "nothing stands there";
    r.table("body_box");
    EXPECT_FALSE(compared(r).find("peak_mean:force_x")) << "what moves has accelerations";
}

/// A body that heaves and pitches about an attitude that it has turned to, its ends 0.5 and 0.3 m from its centre of
/// mass.
TEST(WavePeaks, OfAccelerationsAreThoseOfTheCentreAndOfTheEndThatMeetsTheWaves) {
    const double heave = 0.02, pitch = 0.05, turned = 0.4;
    RunRecord r = in_waves(10);
    Surface box;
    box.points = {{-0.5, 0, 0}, {0.3, 0, 0}, {0, 0.1, 0.1}};
    box.triangles = {{0, 1, 2}};
    r.bodies.push_back({body_table("box"), box, Vec3(0, 0, 0)});
    Table& motion = r.table(body_table("box"));
    for (int i = 0; i <= 4000; ++i) {
        const double t = 0.0025 * i, angle = turned + pitch * std::cos(omega * t + 1);
        const std::size_t row = motion.append(t);
        motion.set(row, "vz", "m/s", -heave * omega * std::sin(omega * t));
        motion.set(row, "spin_x", "rad/s", 0);
        motion.set(row, "spin_y", "rad/s", -pitch * omega * std::sin(omega * t + 1));
        motion.set(row, "q0", "-", std::cos(angle / 2));
        motion.set(row, "qx", "-", 0);
        motion.set(row, "qy", "-", std::sin(angle / 2));
        motion.set(row, "qz", "-", 0);
    }
    // z of the end of arm d: z_c - d sin(angle), by finite differences of the place itself
    const auto highest = [&](double arm) {
        const auto z = [&](double t) {
            return heave * std::cos(omega * t) - arm * std::sin(turned + pitch * std::cos(omega * t + 1));
        };
        double most = 0;
        for (double t = 0; t < T; t += 1e-3) most = std::max(most, (z(t + 1e-3) - 2 * z(t) + z(t - 1e-3)) / 1e-6);
        return most;
    };
    const Comparison c = compared(r);
    EXPECT_NEAR(value(c, "acceleration_centre:box") / highest(0), 1, 0.003);
    EXPECT_NEAR(value(c, "acceleration_bow:box") / highest(-0.5), 1, 0.003);
    r.numbers["wave_direction"] = -1;
    EXPECT_NEAR(value(compared(r), "acceleration_bow:box") / highest(0.3), 1, 0.003);
    EXPECT_GT(std::abs(highest(0.3) / highest(-0.5) - 1), 0.1) << "or the ends are not told apart";
    EXPECT_TRUE(c.find("peak_median:acceleration_bow:box"));
}

}  // namespace wave_peaks_test
}  // namespace tw::test
