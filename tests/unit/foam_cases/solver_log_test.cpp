// What the solver's log says.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "foam_cases/read/solver_log.h"

namespace tw {
namespace solver_log_test {

const char* const header =
    "Date   : Nov 21 2026\n"
    "Time   : 12:32:22\n"
    "Create time\n\nCourant Number mean: 0 max: 0\n";

std::string step(double time, double dt, double courant = 1.5, double water = 0.4) {
    const auto n = [](double v) { return std::to_string(v); };
    char dt_text[32];
    std::snprintf(dt_text, sizeof dt_text, "%.3g", dt);
    return "Courant Number mean: 0.01 max: " + n(courant) +
           "\nInterface Courant Number mean: 0.001 max: " + n(courant / 2) + "\ndeltaT = " + dt_text +
           "\nTime = " + n(time) + "\n\nPIMPLE: iteration 1\nPhase-1 volume fraction = " + n(water) +
           "  Min(alpha.water) = -1e-7  Max(alpha.water) = 1.00001\ntime step continuity errors : sum local = 2e-09, "
           "global = -1e-10, cumulative "
           "= -3e-08\nExecutionTime = 1.5 s  ClockTime = 2 s\n\n";
}

std::string report_of(const std::string& name, double x, double angle) {
    const auto n = [](double v) { return std::to_string(v); };
    const std::string c = n(std::cos(angle)), s = n(std::sin(angle));
    return "Rigid-body motion of the " + name + "\n    Centre of rotation: (" + n(x) + " 0 0.5)\n    Orientation: (" +
           c + " 0 -" + s + " 0 1 0 " + s + " 0 " + c + ")\n    Linear velocity: (1 0 -2)\n    Angular velocity: (0 " +
           n(angle) + " 0)\n";
}

// rigidBodyMotion writes how the earth lies in the body: a turn about +y by `angle` has -sin at the top right.
TEST(SolverLog, HoldsEachOfSeveralBodiesAtEachStepAsItsLastCorrectorLeftIt) {
    std::string text = header;
    for (int k = 1; k <= 2; ++k) {
        std::string one = step(0.1 * k, 0.1);
        const std::string motion = report_of("left", 7, 1) + report_of("right", 8, 1) + report_of("left", k, 0.1 * k) +
                                   report_of("right", -k, 0.2 * k);
        text += one.insert(one.find("ExecutionTime"), motion);
    }
    SolverLog log;
    log.feed(text);
    ASSERT_EQ(log.steps().size(), 2u);
    for (int k = 1; k <= 2; ++k) {
        const auto& bodies = log.steps()[static_cast<std::size_t>(k) - 1].bodies;
        ASSERT_EQ(bodies.size(), 2u);
        EXPECT_EQ(bodies[1].name, "right");
        EXPECT_EQ(bodies[0].centre, Vec3(k, 0, 0.5));
        EXPECT_EQ(bodies[1].centre, Vec3(-k, 0, 0.5));
        EXPECT_EQ(bodies[1].velocity, Vec3(1, 0, -2));
        EXPECT_NEAR(bodies[1].spin.y(), 0.2 * k, 1e-6);
        const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.2 * k, Vec3::UnitY()));
        EXPECT_LT((bodies[1].attitude - turn).norm(), 1e-5);
    }
}

TEST(SolverLog, ReadsStepsWhateverThePiecesItIsFed) {
    const std::string text = header + step(0.1, 0.1) + step(0.25, 0.15, 2.5, 0.41) + "End\n";
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, text.size()}) {
        SolverLog log;
        for (std::size_t at = 0; at < text.size(); at += piece) log.feed(std::string_view(text).substr(at, piece));
        ASSERT_EQ(log.steps().size(), 2u);
        EXPECT_DOUBLE_EQ(log.steps()[1].time, 0.25);
        EXPECT_DOUBLE_EQ(log.steps()[1].step, 0.15);
        EXPECT_DOUBLE_EQ(log.steps()[1].courant, 2.5);
        EXPECT_DOUBLE_EQ(log.steps()[1].alpha_courant, 1.25);
        EXPECT_DOUBLE_EQ(log.steps()[1].water, 0.41);
        EXPECT_DOUBLE_EQ(log.steps()[1].least, -1e-7);
        EXPECT_DOUBLE_EQ(log.steps()[1].most, 1.00001);
        EXPECT_DOUBLE_EQ(log.steps()[1].continuity, 2e-9);
        EXPECT_DOUBLE_EQ(log.steps()[1].cpu, 1.5);
        EXPECT_TRUE(log.ended());
        EXPECT_TRUE(log.fatal().empty());
    }
}

// OpenFOAM's source for a tank that moves says in each step, after the water's volume, at which time it has looked.
TEST(SolverLog, DoesNotTakeTheTalkOfATankThatMovesForAStep) {
    std::string text = header + step(0.1, 0.1, 1.5, 0.41);
    const std::string execution = "ExecutionTime";
    text.insert(text.find(execution), "Time = 0.1 accelerations: ((0 0 0) (0 0.1 0) (0 0 0))\n");
    SolverLog log;
    log.feed(text);
    ASSERT_EQ(log.steps().size(), 1u);
    EXPECT_DOUBLE_EQ(log.steps()[0].water, 0.41);
    EXPECT_DOUBLE_EQ(log.steps()[0].cpu, 1.5);
}

TEST(SolverLog, AfterARestartTheLaterStartWins) {
    SolverLog log;
    log.feed(header + step(0.1, 0.1) + step(0.2, 0.1) + step(0.3, 0.1));  // killed here
    log.feed(header + step(0.15, 0.05) + step(0.2, 0.05));
    ASSERT_EQ(log.steps().size(), 3u);
    EXPECT_DOUBLE_EQ(log.steps()[1].time, 0.15);
    EXPECT_FALSE(log.ended());
    EXPECT_DOUBLE_EQ(log.at(0.17)->time, 0.15);
    EXPECT_DOUBLE_EQ(log.at(0.2)->time, 0.2);
    EXPECT_EQ(log.at(0.05), nullptr);
}

TEST(SolverLog, AStartReplacesAllBeyondTheTimeItStartsFrom) {
    SolverLog log;
    log.feed(header + step(0.1, 0.1) + step(0.13, 0.03) + step(0.16, 0.03));  // killed here
    log.feed(std::string(header) + "Create mesh for time = 0.1\n\n" + step(0.15, 0.05));
    ASSERT_EQ(log.steps().size(), 2u) << "0.13 is no step of this run";
    EXPECT_DOUBLE_EQ(log.steps()[1].time, 0.15);
}

TEST(SolverLog, KeepsOpenFoamsOwnErrorMessage) {
    SolverLog log;
    log.feed(header + step(0.1, 0.1) +
             "\n\n--> FOAM FATAL IO ERROR: \ncannot find file\n\nfile: /x/0.12/p_rgh at line 0.\n\n"
             "    From function regIOobject::readStream\n    in file regIOobjectRead.C at line 88.\n\nFOAM "
             "exiting\n\nlater noise\n");
    EXPECT_NE(log.fatal().find("cannot find file"), std::string::npos);
    EXPECT_NE(log.fatal().find("0.12/p_rgh"), std::string::npos);
    EXPECT_EQ(log.fatal().find("later noise"), std::string::npos);
}

TEST(SolverLog, ReadsOpenFoamOrgsTimesWithTheirUnit) {
    SolverLog log;
    log.feed("deltaT = 0.01\nTime = 0.05s\n");
    ASSERT_EQ(log.steps().size(), 1u);
    EXPECT_DOUBLE_EQ(log.steps()[0].time, 0.05);
}

}  // namespace solver_log_test
}  // namespace tw
