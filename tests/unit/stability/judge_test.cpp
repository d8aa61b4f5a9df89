#include "stability/judge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace judge_test {

HardCaseRun run_with(const std::vector<RecordedCheck>& lines) {
    HardCaseRun run;
    run.steps = 100;
    run.lines = lines;
    return run;
}

TEST(StabilityJudgement, WithinAllLimitsIsStableAndTheLabelIsTheNearestGate) {
    const StabilityJudgement j = judge_stability({}, run_with({{"Mach number", "-", 0.12}, {"compression", "%", 1}}));
    EXPECT_EQ(j.stability, Stability::stable);
    EXPECT_EQ(j.reason, "");
    EXPECT_EQ(j.label, "Ma 0.12");
    EXPECT_EQ(judge_stability({}, run_with({{"Mach number", "-", 0.15}})).stability,
              Stability::stable);  // the limit itself
}

TEST(StabilityJudgement, ASoundSpeedThatIsTooLowIsSaid) {
    const StabilityJudgement j = judge_stability({}, run_with({{"Mach number", "-", 0.3}, {"compression", "%", 11}}));
    EXPECT_EQ(j.stability, Stability::warned);
    EXPECT_EQ(j.reason, "c0 too low: Mach number 0.3 above 0.15, compression 11 % above 5 %");
    EXPECT_EQ(j.label, "rho +11 %");
    // with a time step longer than stated, c0 alone is not to blame
    HardCase c;
    c.cfl = 1.5;
    EXPECT_EQ(judge_stability(c, run_with({{"Mach number", "-", 0.3}})).reason,
              "time step too long or c0 too low: Mach number 0.3 above 0.15");
}

TEST(StabilityJudgement, ABrokenLawFailsAndOutweighsWarnings) {
    for (const char* line : {"particles lost", "particles missing"})
        EXPECT_EQ(judge_stability({}, run_with({{line, "-", 1}})).stability, Stability::failed) << line;
    const auto energy = [](double made) {
        return judge_stability({}, run_with({{"Mach number", "-", 0.2}, {"energy made", "%", made}}));
    };
    EXPECT_EQ(energy(0.05).reason, "c0 too low: Mach number 0.2 above 0.15");
    EXPECT_EQ(energy(0.5).stability, Stability::warned);
    EXPECT_EQ(energy(2).stability, Stability::failed);
    EXPECT_EQ(energy(2).reason,
              "it violates a physical law: energy made 2 % above 1 %; c0 too low: Mach number 0.2 above 0.15");
}

TEST(StabilityJudgement, WhatTheEngineSaidIsTheReason) {
    HardCaseRun run = run_with({{"Mach number", "-", 0.1}});
    run.failure = "particle 7 has gone through the hull";
    const StabilityJudgement j = judge_stability({}, run);
    EXPECT_EQ(j.stability, Stability::failed);
    EXPECT_EQ(j.reason, run.failure);
    EXPECT_EQ(j.label, "stopped");
}

TEST(StabilityJudgement, NotANumberAndNothingAtAllDoNotPass) {
    for (const StabilityLimit& gate : stability_limits())
        EXPECT_EQ(judge_stability({}, run_with({{gate.line, gate.unit, std::nan("")}})).stability, Stability::failed)
            << gate.line;
    EXPECT_EQ(judge_stability({}, {}).stability, Stability::failed);
}

}  // namespace judge_test
}  // namespace tw
