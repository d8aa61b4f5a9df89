// Rows that a run should have left, measured against the solver's log and the write interval.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "foam_cases/read/gaps.h"
#include "tests/unit/foam_cases/scenes.h"

namespace tw {
namespace gaps_test {

/// A run of the planing hull with a pressure probe: 20 steps of 0.01 s, a write time every 0.05 s, all of it there.
class GapsTest : public testing::Test {
protected:
    Scene scene = [] {
        Scene s = planing_scene();
        s.sampling.pressure = {{"keel", Vec3(1, 0, -0.1)}};
        return s;
    }();
    CasePlan plan = [this] {
        CasePlan p = plan_case(scene, Flavour{});
        p.writes_at_steps = false;  // as of a hull that is free, or of a section: write times are met exactly
        return p;
    }();
    SolverLog log;
    RunRecord record;

    void SetUp() override {
        record.numbers["write_interval"] = 0.05;
        for (int i = 1; i <= 20; ++i) {
            const double time = 0.01 * i;
            log.feed(fmt::format("deltaT = 0.01\nTime = {:.6g}\n", time));
            for (const char* table : {"forces_total", "pressure"})
                record.table(table).time.push_back(time * (1 + 1e-7));  // the tables round otherwise than the log
        }
        for (const char* table : {"samples", "forces"}) record.table(table).time = {0.05, 0.1, 0.15, 0.2};
    }
    std::string gap(double until = 0.2) const {
        const auto found = first_gap(plan, log, record, until);
        return found ? fmt::format("{:g}: {}", found->time, found->what) : "none";
    }
    void lose(const char* table, std::size_t from, std::size_t to) {
        auto& time = record.table(table).time;
        time.erase(time.begin() + static_cast<std::ptrdiff_t>(from), time.begin() + static_cast<std::ptrdiff_t>(to));
    }
};

TEST_F(GapsTest, AWholeRunHasNone) { EXPECT_EQ(gap(), "none"); }

TEST_F(GapsTest, OneRowOfTwentyIsNamedWithItsTable) {
    lose("forces_total", 0, 19);
    EXPECT_EQ(gap(), "0.01: forces_total has rows for 1 of 20 time steps, the first is missing at t = 0.01 s");
    record.tables.erase("forces_total");
    EXPECT_EQ(gap(), "0.01: forces_total has rows for 0 of 20 time steps, the first is missing at t = 0.01 s");
}

TEST_F(GapsTest, TheEarliestOfSeveralIsTold) {
    lose("forces_total", 12, 13);
    lose("pressure", 7, 9);
    EXPECT_EQ(gap(), "0.08: pressure has rows for 18 of 20 time steps, the first is missing at t = 0.08 s");
    EXPECT_EQ(gap(0.07), "none") << "up to there all is whole";
}

TEST_F(GapsTest, AWriteTimeInTheMiddleOrAtTheEndIsMissed) {
    lose("forces", 1, 2);  // the hull's surface was not written
    EXPECT_EQ(gap(), "0.1: forces has rows for 3 of 4 write times, the first is missing at t = 0.1 s");
    lose("samples", 0, 1);
    EXPECT_EQ(gap(), "0.05: samples has rows for 3 of 4 write times, the first is missing at t = 0.05 s");
}

TEST_F(GapsTest, WithoutAHullOrProbesNothingIsAskedOfThem) {
    const Scene tank = dam_break_scene();
    const CasePlan tank_plan = plan_case(tank, Flavour{});
    for (const char* table : {"forces_total", "forces", "pressure"}) record.tables.erase(table);
    EXPECT_FALSE(first_gap(tank_plan, log, record, 0.2));
}

TEST_F(GapsTest, ForcesOnWhatStandsInATankAreMissedWhereTheCaseWasToKeepThem) {
    Scene tank = dam_break_scene();
    tank.obstacles.push_back({"pier", make_hull("box", {{"length", 0.1}, {"beam", 0.1}, {"height", 0.1}})});
    const CasePlan tank_plan = plan_case(tank, Flavour{});
    for (const char* table : {"forces_total", "forces"}) record.tables.erase(table);
    EXPECT_FALSE(first_gap(tank_plan, log, record, 0.2)) << "begun by a version that did not keep them";
    record.attributes[loads_of] = "all solids";
    const auto found = first_gap(tank_plan, log, record, 0.2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->what, "forces_total has rows for 0 of 20 time steps, the first is missing at t = 0.01 s");
}

TEST_F(GapsTest, InATankRowsFollowTheStepsAndAreMissedAllTheSame) {
    const Scene tank = dam_break_scene();
    const CasePlan tank_plan = plan_case(tank, Flavour{});
    record.tables.clear();
    std::vector<double>& rows = record.table("samples").time;
    rows = {0.05, 0.09, 0.15, 0.2};  // 0.1 s has fallen to the step before
    EXPECT_FALSE(first_gap(tank_plan, log, record, 0.2));
    rows = {0.05, 0.15, 0.2};
    const auto found = first_gap(tank_plan, log, record, 0.2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->what, "samples has no row from t = 0.05 to 0.15 s, expected one every 0.05 s");
    rows = {0.05, 0.1};
    EXPECT_TRUE(first_gap(tank_plan, log, record, 0.2)) << "the end is missed";
}

TEST_F(GapsTest, WithoutALogTheWriteTimesStillCount) {
    record.tables.erase("forces_total");
    EXPECT_FALSE(first_gap(plan, SolverLog(), record, 0.2));
    EXPECT_TRUE(first_gap(plan, SolverLog(), record, 0.26));
    plan.writes_at_steps = true;
    for (const char* table : {"samples", "forces"}) record.table(table).time = {0.053, 0.098, 0.153, 0.2};
    EXPECT_FALSE(first_gap(plan, SolverLog(), record, 0.2)) << "how long steps were is not known";
    for (const char* table : {"samples", "forces"}) record.table(table).time = {0.053, 0.2};
    EXPECT_TRUE(first_gap(plan, SolverLog(), record, 0.2));
}

}  // namespace gaps_test
}  // namespace tw
