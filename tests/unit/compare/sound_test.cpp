// Sound in the peaks of a weakly compressible method: told from the record alone, named, and not judged.
#include "compare/metrics/sound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"
#include "compare/grid_study/grid_study.h"
#include "compare/grid_study/judge_by_sizes.h"

namespace tw {
namespace sound_test {

constexpr double dp = 0.01, v = 2.7, rho = 1000;

/// A wall that water reaches at 0.4 s. What the flow does to it: a pulse of `flow` [Pa] that decays in 30 ms to a third of
/// it. What the particles' blunt front adds: rho c0 v for 3 dp/c0, whatever the flow.
RunRecord struck(const std::string& method, double size, double c0, double flow, bool blunt) {
    RunRecord r;
    r.attributes = {{"method", method}, {"title", "wall"}, {"motion", "none"}};
    r.numbers = {{"near_hull", size}, {"spacing", size}, {"duration", 1}, {"dimensions", 2}, {"mean_from", 0}};
    if (c0 > 0) r.numbers["c0"] = c0;
    r.state = "finished";
    Table &pressure = r.table("pressure"), &forces = r.table("forces");
    for (int k = 0; k <= 10000; ++k) {
        const double t = 1e-4 * k, since = t - 0.4;
        double p = since < 0 ? 0 : flow * (1 + 2 * std::exp(-since / 0.03)) / 3;
        if (blunt && since >= 0 && since < 3 * size / c0) p += rho * c0 * v;
        const std::size_t row = pressure.append(t), line = forces.append(t);
        pressure.set(row, "P", "Pa", p);
        forces.set(line, "fx", "N", -0.01 * p);
        forces.set(line, "fz", "N", 0);
    }
    return r;
}

TEST(Sound, WhatLastsIsTheHistoryWithoutItsShortPulses) {
    std::vector<double> t, x;
    for (int k = 0; k <= 100; ++k) {
        t.push_back(0.01 * k);
        x.push_back(k >= 20 && k <= 22 ? 9 : k >= 50 && k <= 70 ? 5 : 1);
    }
    const std::vector<double> lasts = lasting(t, x, 0.1);
    EXPECT_EQ(lasts[21], 1) << "20 ms long";
    EXPECT_EQ(lasts[50], 5) << "200 ms long, whole";
    EXPECT_EQ(lasts[60], 5);
    EXPECT_EQ(lasts[70], 5);
    EXPECT_EQ(lasts[0], 1);
    EXPECT_EQ(lasts[100], 1);
    for (std::size_t k = 0; k < t.size(); ++k) EXPECT_LE(lasts[k], x[k]) << k;
    x[60] = nan;
    const std::vector<double> in_two = lasting(t, x, 0.1);
    EXPECT_TRUE(std::isnan(in_two[60]));
    EXPECT_EQ(in_two[55], 1) << "each half of it is shorter than 100 ms, but for what stands beside it";
    EXPECT_EQ(lasting(t, x, 0)[21], 9) << "no sound, nothing left out";
}

TEST(Sound, APeakThatGrowsWithTheSoundSpeedIsNotJudged) {
    double before = 0;
    for (const double c0 : {24.0, 48.0}) {
        const Comparison c = compare_records({struck("sph", dp, c0, 7000, true)});
        const Quantity &raw = *c.find("pressure:P"), &peak = *c.find("pressure_peak:P"), &load = *c.find("load_peak_x");
        EXPECT_GT(raw.values[0].value, 1.7 * before) << "it goes with c0";
        before = raw.values[0].value;
        EXPECT_NE(peak.not_resolved.find("SPH: not judged: sound of the impact"), std::string::npos)
            << peak.not_resolved;
        EXPECT_TRUE(std::isnan(peak.values[0].bar())) << "no interval";
        EXPECT_NE(load.not_resolved, "") << "of the opposite sign too";
        EXPECT_NEAR(c.find("pressure_arrival:P")->values[0].value, 0.4, 1e-3) << "water still arrives";
        EXPECT_EQ(c.find("pressure_mean:P")->not_resolved, "");
        EXPECT_EQ(c.find("pressure_p99:P")->not_resolved, "") << "exceeded for longer than sound lasts";
    }
}

TEST(Sound, APeakOfTheFlowIsJudgedHoweverHigh) {
    for (const double flow : {7000.0, 60e3}) {
        const Comparison c = compare_records({struck("sph", dp, 24, flow, false)});
        EXPECT_EQ(c.find("pressure_peak:P")->not_resolved, "") << flow;
        EXPECT_EQ(c.find("load_peak_x")->not_resolved, "") << flow;
        EXPECT_TRUE(std::isfinite(c.find("pressure_peak:P")->values[0].bar()));
    }
    const Comparison mesh = compare_records({struck("fvm", dp, 0, 7000, false)});
    EXPECT_EQ(mesh.find("pressure_peak:P")->not_resolved, "") << "a method without sound";
    EXPECT_EQ(sound_time(struck("fvm", dp, 0, 7000, false)), 0);
    EXPECT_NEAR(sound_time(struck("sph", dp, 24, 7000, false)), 6 * dp / 24, 1e-12);
}

TEST(Sound, AGridStudyLeavesItOutAndTheReportSaysWhy) {
    std::vector<GridStudyRun> runs;
    for (const double size : {dp, 1.4142 * dp, 2 * dp}) {
        runs.push_back(grid_study_run(struck("sph", size, 24, 7000, true)));
        runs.push_back(grid_study_run(struck("fvm", size, 0, 7000 * (1 - 5 * size), false)));
    }
    const GridStudy grid_study = build_grid_study(runs);
    Comparison c =
        compare_records({struck("sph", dp, 24, 7000, true), struck("fvm", dp, 0, 7000 * (1 - 5 * dp), false)});
    judge_by_sizes(c, grid_study);
    const Quantity& peak = *c.find("pressure_peak:P");
    EXPECT_TRUE(std::isnan(peak.values[0].bar()));
    EXPECT_TRUE(std::isfinite(peak.values[1].bar())) << "the other method's stands";
    EXPECT_GT(peak.values[1].bar(), 0);
    EXPECT_NE(peak.verdict, Verdict::agree);
    EXPECT_NE(peak.verdict, Verdict::differ);
    EXPECT_NE(comparison_json(c).find("sound of the impact"), std::string::npos);
    EXPECT_NE(summary_text(c).find("sound of the impact"), std::string::npos);
}

}  // namespace sound_test
}  // namespace tw
