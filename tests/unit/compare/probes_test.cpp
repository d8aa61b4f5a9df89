// What is made of the series of pressure and height probes: means, peaks, arrivals.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/compare.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace probes_test {

using namespace synthetic_pair;

TEST(Probes, AProbesMeanIsThatOfTheScenesTimeWhateverTheRecordsStepsAndEnd) {
    // p = 100 t: over 0 to 2 s the mean is 100 Pa, in steps that crowd at the end and beyond it too
    const auto tank = [](const std::string& method, double end, double power) {
        RunRecord r = synthetic_run({.method = method, .frames = false});
        r.attributes["motion"] = "none";
        r.numbers["speed"] = 0, r.numbers["mean_from"] = 0, r.numbers["duration"] = 2;
        Table& t = r.tables["pressure"];
        t.columns = {{"P1", "Pa", {}}};
        for (int k = 0; k <= 50; ++k) {
            t.time.push_back(end * (1 - std::pow(1 - k / 50., power)));
            t.columns[0].values.push_back(100 * t.time.back());
        }
        return r;
    };
    const Comparison c = compare_records({tank("sph", 2, 1), tank("fvm", 3.7, 2)});
    const Quantity* mean = c.find("pressure_mean:P1");
    ASSERT_NE(mean, nullptr);
    EXPECT_NEAR(mean->values[0].value, 100, 1e-9);
    EXPECT_NEAR(mean->values[1].value, 100, 1e-9);
    EXPECT_FALSE(mean->judged);  // no interval without a grid study
    EXPECT_TRUE(mean->judged_in_grid_study);
    EXPECT_FALSE(c.find("pressure:P1")->judged);  // a peak is not
    const Comparison cut = compare_records({tank("sph", 2, 1), tank("fvm", 1.5, 1)});
    EXPECT_FALSE(cut.find("pressure_mean:P1")->values[1].known);
}

// A roller's level swings by 1 mm with a memory of half a second: 6 s of it are a dozen independent values.
TEST(Probes, AMeanOfAStreamWithoutAHullHasTheScatterOfItsTimeAndOneOfATankHasNone) {
    const auto run = [](const std::string& motion, double swing, double wave_period) {
        RunRecord r = synthetic_run({.method = "sph", .frames = false});
        r.attributes["motion"] = motion;
        r.numbers["length"] = 0, r.numbers["mean_from"] = 2, r.numbers["duration"] = 8;
        if (wave_period > 0) r.numbers["wave_period"] = wave_period;
        Table& t = r.tables["height"];
        t.columns = {{"G", "m", {}}};
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        double state = normal(random);
        const double rho = std::exp(-0.025 / 0.25);
        for (int k = 0; k <= 320; ++k) {
            state = rho * state + std::sqrt(1 - rho * rho) * normal(random);
            t.time.push_back(0.025 * k);
            t.columns[0].values.push_back(k < 80 ? -0.5 : 0.1 + swing * state);  // the start counts in nothing
        }
        return r;
    };
    const auto half_width = [](const RunRecord& r) {
        const Comparison c = compare_records({r});
        const Quantity* mean = c.find("height_mean:G");
        EXPECT_NEAR(mean->values[0].value, 0.1, 1.5e-3);
        return mean->values[0].half_width;
    };
    const double U = half_width(run("stream", 1e-3, 0));
    EXPECT_GT(U, 0.3e-3);  // 240 samples alone, taken as independent, would give 0.13 mm
    EXPECT_LT(U, 2e-3);
    EXPECT_NEAR(half_width(run("stream", 2e-3, 0)), 2 * U, 1e-9);
    EXPECT_EQ(half_width(run("none", 1e-3, 0)), 0);
    EXPECT_EQ(half_width(run("stream", 1e-3, 0.5)), 0);
}

TEST(Probes, APeakIsThatOfTheTimeThatAllRecordsCover) {
    const auto gauge = [](const std::string& method, double end) {  // p rises to 1000 Pa at 1 s, and to 9000 Pa at 3 s
        RunRecord r = synthetic_run({.method = method, .frames = false});
        Table& t = r.tables["pressure"];
        t.columns = {{"P1", "Pa", {}}};
        for (double time = 0; time <= end; time += 0.05) {
            t.time.push_back(time);
            t.columns[0].values.push_back(time < 2 ? 1000 * std::exp(-std::pow((time - 1) / 0.1, 2)) : 9000);
        }
        return r;
    };
    const Comparison c = compare_records({gauge("sph", 1.8), gauge("basin", 3)});
    EXPECT_NEAR(c.find("pressure:P1")->values[0].value, 1000, 10);
    EXPECT_NEAR(c.find("pressure:P1")->values[1].value, 1000, 10);
    EXPECT_NEAR(compare_records({gauge("basin", 3)}).find("pressure:P1")->values[0].value, 9000, 1);
}

/// A wall that water reaches at 1 s: 1000 Pa from then on, and at 1.2 s the sound of an impact, 46 kPa for 0.2 ms.
RunRecord struck_wall(const std::string& method, double step, bool sound) {
    RunRecord r = synthetic_run({.method = method, .frames = false});
    r.attributes["motion"] = "none";
    r.numbers["speed"] = 0, r.numbers["mean_from"] = 0, r.numbers["duration"] = 2;
    Table& t = r.tables["pressure"];
    t.columns = {{"P1", "Pa", {}}};
    const auto count = std::lround(2 / step);
    for (long k = 0; k <= count; ++k) {
        const double time = static_cast<double>(k) * step;
        double p = time < 1 - 1e-9 ? 0 : 1000;
        if (sound && std::abs(time - 1.2) < 1e-9) p = 46e3;
        t.time.push_back(time);
        t.columns[0].values.push_back(p);
    }
    return r;
}

TEST(Probes, APeakIsJudgedByItsImpulseAndNotByItsSound) {
    const Comparison c = compare_records({struck_wall("sph", 1e-4, true), struck_wall("fvm", 1e-3, false)});
    const auto values = [&](const char* name) {
        const Quantity* q = c.find(name);
        EXPECT_NE(q, nullptr) << name;
        return std::pair(q->values[0].value, q->values[1].value);
    };
    EXPECT_EQ(values("pressure:P1"), std::pair(46e3, 1e3));
    EXPECT_FALSE(c.find("pressure:P1")->judged || c.find("pressure:P1")->judged_in_grid_study) << "raw: by no one";
    const auto [with_sound, without] = values("pressure_peak:P1");
    EXPECT_NEAR(with_sound, 1000 + 45e3 * 1e-4 / 5e-3, 1) << "a triangle of 0.2 ms, over 5 ms";
    EXPECT_NEAR(without, 1000, 1e-6);
    EXPECT_TRUE(c.find("pressure_peak:P1")->judged_in_grid_study);
    EXPECT_NEAR(values("pressure_p99:P1").first, 1000, 1) << "0.01 % of the time";
    EXPECT_TRUE(c.find("pressure_p99:P1")->judged_in_grid_study);
    const auto [a, b] = values("pressure_arrival:P1");
    EXPECT_NEAR(a, 1, 1.1e-4);
    EXPECT_NEAR(b, 1, 1.1e-3);
    EXPECT_EQ(c.find("pressure_arrival:P1")->unit, "s");
    EXPECT_TRUE(c.find("pressure_arrival:P1")->judged_in_grid_study);
}

TEST(Probes, APeakIsAMeanOverTheTimeThatTheSceneSays) {
    std::vector<RunRecord> pair{struck_wall("sph", 1e-4, true), struck_wall("fvm", 1e-4, true)};
    for (RunRecord& r : pair) r.numbers[peak_filter("pressure", "P1")] = 1e-3;
    const Comparison c = compare_records(pair);
    const Quantity& peak = *c.find("pressure_peak:P1");
    EXPECT_NEAR(peak.values[0].value, 1000 + 45e3 * 1e-4 / 1e-3, 1) << "a triangle of 0.2 ms, over 1 ms";
    EXPECT_NE(peak.label.find("mean over 1 ms"), std::string::npos) << peak.label;
    EXPECT_TRUE(peak.judged_in_grid_study) << "with an interval, as that over 5 ms";
}

TEST(Probes, AProbeThatNothingReachesHasNoArrival) {
    RunRecord dry = struck_wall("sph", 1e-3, false);
    for (double& p : dry.tables["pressure"].columns[0].values) p = 0;
    const Comparison c = compare_records({dry});
    EXPECT_FALSE(c.find("pressure_arrival:P1")->values[0].known);
    EXPECT_NE(c.find("pressure_arrival:P1")->values[0].why_not.find("nothing arrives"), std::string::npos);
}

TEST(Probes, SamplesFurtherApartThan5MillisecondsWidenTheFilterOfAllAndFramesDoNot) {
    const auto label = [](const std::vector<RunRecord>& records) {
        return compare_records(records).find("pressure_peak:P1")->label;
    };
    RunRecord fine = struck_wall("sph", 1e-3, false);
    fine.numbers["sampling_interval"] = 0.05;  // of the frames
    EXPECT_NE(label({fine}).find("over 5 ms"), std::string::npos) << label({fine});
    const RunRecord coarse = struck_wall("fvm", 0.02, false);
    EXPECT_NE(label({fine, coarse}).find("over 20 ms"), std::string::npos) << label({fine, coarse});
}

}  // namespace probes_test
}  // namespace tw
