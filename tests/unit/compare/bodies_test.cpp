// What is compared of a body that moves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/compare.h"
#include "compare/metrics/bodies.h"
#include "compare/report/sentences.h"

namespace tw {
namespace bodies_test {

/// A ball that falls with speed 2 m/s for 0.1 s, then is braked by 3000 N for 0.1 s; rows every `step`, all `late`.
RunRecord falling(const std::string& method, double step, double late = 0, double factor = 1) {
    RunRecord r;
    r.attributes = {{"method", method}, {"motion", "none"}, {"scene_hash", "s"}, {"hull_hash", ""}};
    r.numbers = {{"duration", 0.2}, {"gravity", 9.81}, {"density", 1000}};
    r.state = "finished";
    Table& t = r.table("body_ball");
    for (int i = 0; i * step <= 0.2001; ++i) {
        const double time = i * step, hit = std::max(0.0, time - 0.1 - late);
        t.time.push_back(time);
        t.column("z", "m").values.push_back(1 - 2 * time + 5 * hit * hit);
        t.column("vz", "m/s").values.push_back(-2 + 10 * hit);
        t.column("fz", "N").values.push_back(i < 3 && method == "fvm" ? std::nan("") : hit > 0 ? factor * 3000 : 0);
        t.column("q0", "-").values.push_back(std::cos(std::numbers::pi / 36));  // turned by ten degrees
    }
    return r;
}

double value(const Comparison& c, const char* name, std::size_t source = 0) {
    const Quantity* q = c.find(name);
    return q && source < q->values.size() ? q->values[source].value : std::nan("");
}

TEST(Bodies, AreMeasuredByDepthSpeedPeakArrivalAndImpulse) {
    const Comparison c = compare_records({falling("sph", 1e-3)});
    EXPECT_NEAR(value(c, "body_depth:ball"), 0.35, 1e-9);
    EXPECT_NEAR(value(c, "body_speed:ball"), 1, 1e-9);
    EXPECT_NEAR(value(c, "body_peak:ball"), 3000, 1e-6);
    EXPECT_NEAR(value(c, "body_arrival:ball"), 0.1, 1.1e-3);
    EXPECT_NEAR(value(c, "body_impulse:ball"), 300, 3);
    EXPECT_NEAR(value(c, "body_turn:ball"), 10, 1e-6);
    EXPECT_EQ(c.find("body_depth:ball")->unit, "m");
    EXPECT_EQ(c.find("body_impulse:ball")->unit, "N s");
    EXPECT_TRUE(c.find("body_depth:ball")->judged_in_grid_study);
}

TEST(Bodies, InWavesWhereTheyAreAtTheEndHasNoVerdict) {
    for (const char* const period : {"wave_period", "sea_peak_period"}) {
        RunRecord in_waves = falling("sph", 1e-3);
        in_waves.numbers[period] = 1.2;
        const Comparison c = compare_records({in_waves});
        ASSERT_TRUE(c.find("body_depth:ball") && c.find("body_speed:ball"));
        EXPECT_FALSE(c.find("body_depth:ball")->judged_in_grid_study);
        EXPECT_FALSE(c.find("body_speed:ball")->judged_in_grid_study);
        EXPECT_TRUE(c.find("body_peak:ball")->judged_in_grid_study);
    }
}

TEST(Bodies, ThePeakIsAMeanOverTheTimeThatTheSceneSays) {
    RunRecord r = falling("sph", 1e-3);
    for (const double filter : {5e-3, 0.15}) {  // the force lasts for the last 0.1 s
        r.numbers[peak_filter("body", "ball")] = filter;
        const Comparison c = compare_records({r});
        EXPECT_NEAR(value(c, "body_peak:ball"), filter < 0.1 ? 3000 : 3000 * 0.1 / 0.15, 25) << filter;
        EXPECT_NE(c.find("body_peak:ball")->label.find(filter < 0.1 ? "5 ms" : "150 ms"), std::string::npos);
    }
}

TEST(Bodies, StepsAndFalseStartsDoNotCount) {
    const Comparison c = compare_records({falling("sph", 1e-3), falling("fvm", 3.7e-4)});
    EXPECT_NEAR(value(c, "body_depth:ball", 1) / value(c, "body_depth:ball", 0), 1, 1e-3);
    EXPECT_NEAR(value(c, "body_impulse:ball", 1) / value(c, "body_impulse:ball", 0), 1, 0.02)
        << "a row apart at the blow";
    EXPECT_NE(c.find("body_impulse:ball")->remark.find("ratio"), std::string::npos);
}

TEST(Bodies, TheLagIsThatOfTheLaterHistory) {
    const RunRecord a = falling("sph", 1e-3), b = falling("fvm", 1e-3, 0.012);
    const auto lag = [](const RunRecord& x, const RunRecord& y) {
        const Table &s = x.tables.at("body_ball"), &t = y.tables.at("body_ball");
        return lag_of(s.time, s.find("vz")->values, t.time, t.find("vz")->values);
    };
    EXPECT_NEAR(lag(a, b), 0.012, 2e-4);
    EXPECT_NEAR(lag(b, a), -0.012, 2e-4);
    EXPECT_NEAR(lag(a, a), 0, 1e-12);
}

// The first page of a fall speaks of the fall: a body that moves has no settled drag and lift.
TEST(Bodies, StandFirstAndHaveNoSettledLoad) {
    std::vector<RunRecord> two{falling("sph", 1e-3), falling("fvm", 1e-3, 0.012)};
    for (RunRecord& r : two) {
        Table& forces = r.table("forces");
        forces.time = r.tables.at("body_ball").time;
        for (const char* column : {"fx", "fz", "my"}) forces.column(column, "N").values.assign(forces.time.size(), 1);
    }
    const Comparison c = compare_records(std::move(two));
    EXPECT_EQ(c.find("lift"), nullptr);
    const std::vector<std::string> sentences = verdict_sentences(c);
    ASSERT_EQ(sentences.size(), 3u);
    EXPECT_EQ(sentences[0].find("Way down of ball at 0.2 s: apart by"), 0u) << sentences[0];
    EXPECT_NE(sentences[0].find("discretisation error not estimated"), std::string::npos);
    EXPECT_EQ(sentences[1].find("Velocity downward of ball"), 0u);
    EXPECT_EQ(sentences[2].find("Largest force on ball"), 0u);
}

TEST(Bodies, ARecordWithoutTheBodySaysSo) {
    RunRecord none = falling("fvm", 1e-3);
    none.tables.clear();
    const Comparison c = compare_records({falling("sph", 1e-3), none});
    EXPECT_FALSE(c.find("body_depth:ball")->values[1].known);
    EXPECT_FALSE(c.find("body_depth:ball")->values[1].why_not.empty());
}

}  // namespace bodies_test
}  // namespace tw
