#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "record/run_record.h"
#include "statistics/approach.h"
#include "statistics/flow_through.h"
#include "statistics/settled_loads.h"
#include "statistics/settled_mean.h"
#include "statistics/whole_periods.h"

namespace tw {
namespace settled_loads_test {

constexpr double frame = 0.04, step = 0.02;

/// A hull of length 0.76 at speed 1, means from 1.5 on: lift by `lift`, drag a tenth of it.
RunRecord record_of(double end, const std::function<double(double)>& lift) {
    RunRecord r;
    r.numbers = {{"mean_from", 1.5}, {"length", 0.76}, {"speed", 1.0}};
    Table &forces = r.table("forces"), &samples = r.table("samples");
    std::vector<double> fz, fx;
    for (int i = 1; i * step <= end * (1 + 1e-9); ++i) {
        forces.time.push_back(i * step);
        fz.push_back(lift(i * step));
        fx.push_back(0.1 * fz.back());
        if (i % 2 == 0) samples.time.push_back(i * step);
    }
    forces.column("fz", "N").values = fz;
    forces.column("fx", "N").values = fx;
    return r;
}

/// Correlated noise of standard deviation 1.
std::function<double(double)> noise(double tau, unsigned seed) {
    const double rho = std::exp(-step / tau);
    return [rho, random = std::mt19937(seed), state = 0.0](double) mutable {
        std::normal_distribution<double> normal;
        return state = rho * state + std::sqrt(1 - rho * rho) * normal(random);
    };
}

/// The frame at which a run of this record would have ended; 0: it goes on to its bound.
double end_of(const RunRecord& whole, const SettledStop& rule = {}) {
    for (const double t : whole.tables.at("samples").time) {
        RunRecord so_far = whole;
        so_far.rewind(t * (1 + 1e-9));
        if (is_look(so_far, rule) && settled_loads(so_far, rule).settled) return t;
    }
    return 0;
}

std::string why_at_end(const RunRecord& whole) { return settled_loads(whole, {}).sentence(); }

TEST(SettledLoads, SteadyLoadsEndARunSoonAfterTheFewestFlowThroughTimes) {
    auto n = noise(0.05, 3);
    const double end = end_of(record_of(8, [&](double t) { return 100 + 0.3 * n(t); }));
    EXPECT_GE(end, 1.5 + 1.5 * 0.76);
    EXPECT_LE(end, 4.0);
}

TEST(SettledLoads, ADriftKeepsARunGoing) {
    auto n = noise(0.05, 4);
    const RunRecord r = record_of(6, [&](double t) { return 100 + 3 * t + 0.3 * n(t); });
    EXPECT_EQ(end_of(r), 0);
    EXPECT_NE(why_at_end(r), "");
}

// 4 % to each side, once in four flow-through times: within half of it the load looks steady.
TEST(SettledLoads, ASlowOscillationKeepsARunGoing) {
    auto n = noise(0.05, 5);
    EXPECT_EQ(end_of(record_of(
                  6, [&](double t) { return 100 + 4 * std::sin(2 * std::numbers::pi * t / (4 * 0.76)) + 0.3 * n(t); })),
              0);
}

// The same scatter as of the steady loads below, but of 40 times the correlation time: fewer than ten are independent.
TEST(SettledLoads, TooFewIndependentSamplesKeepARunGoing) {
    auto slow = noise(2, 6), fast = noise(0.05, 6);
    const RunRecord r = record_of(6, [&](double t) { return 100 + 3 * slow(t); });
    EXPECT_EQ(end_of(r), 0) << why_at_end(r);
    EXPECT_GT(end_of(record_of(8, [&](double t) { return 100 + 3 * fast(t); })), 0);
}

TEST(SettledLoads, AScatterAboveWhatIsWantedKeepsARunGoing) {
    auto n = noise(0.2, 7);
    const RunRecord r = record_of(4, [&](double t) { return 100 + 10 * n(t); });
    EXPECT_EQ(end_of(r), 0);
}

TEST(Approach, OfWhatAMeanStillLacksIsThatOfTheExponential) {
    auto n = noise(0.1, 8);
    const RunRecord r = record_of(3.5, [&](double t) { return 100 * (1 - 0.3 * std::exp(-t / 1.5)) + n(t); });
    const Table& forces = r.tables.at("forces");
    const Approach a = approach_of(forces.time, forces.find("fz")->values, 2);
    const double left = 30 * 1.5 * (std::exp(-2 / 1.5) - std::exp(-3.5 / 1.5)) / 1.5;
    EXPECT_NEAR(a.lacking, left, 3 * a.error + 0.2 * left);
}

// Three tenths that are made up for over a length are hidden in the window by a noise of 1.5 %. Of 60 such runs 6 end while
// their mean is wrong by more than 1.5 %; without the approach 15 would.
TEST(SettledLoads, AnApproachIsSeenThatATrendInTheWindowHides) {
    int wrong = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        auto n = noise(0.06, 200 + seed);
        RunRecord r = record_of(6, [&](double t) { return 100 * (1 - 0.3 * std::exp(-t)) + 1.5 * n(t); });
        const double end = end_of(r);
        if (end == 0) continue;
        r.rewind(end * (1 + 1e-9));
        SettledRules rules;
        rules.from = 1.5, rules.flow_through = flow_through_time(r);
        wrong += settled_mean(r.tables.at("forces").time, r.series("forces", "fz")->values, rules).value < 98.5;
    }
    EXPECT_LE(wrong, 10);
}

TEST(SettledLoads, WithWavesARunEndsAfterWholePeriodsAndNotBeforeTwo) {
    auto n = noise(0.05, 9);
    const double period = 2.3;
    const RunRecord r =
        record_of(12, [&](double t) { return 100 + 0.5 * std::sin(2 * std::numbers::pi * t / period) + 0.2 * n(t); });
    const double end = end_of(r, {.period = period}), periods = (end - 1.5) / period;
    ASSERT_GT(end, 0);
    EXPECT_GE(periods, 2);
    EXPECT_LE(end - 1.5 - std::floor(periods) * period, frame);
}

TEST(SettledLoads, TheTrimMomentIsMeasuredByTheLift) {
    const auto with_moment = [&](double size) {
        auto n = noise(0.05, 10);
        RunRecord r = record_of(6, [&](double) { return 100.0; });
        std::vector<double>& my = r.table("forces").column("my", "N m").values;
        for (std::size_t i = 0; i < r.tables.at("forces").time.size(); ++i) my.push_back(size * n(0));
        return r;
    };
    EXPECT_GT(end_of(with_moment(0.01 * 0.1 * 100 * 0.76)), 0) << "a moment of nothing has no per cent of its own";
    EXPECT_EQ(end_of(with_moment(100)), 0);
}

TEST(SettledLoads, ARunThatWasEndedIsKnownToTwoPerCentAtBest) {
    RunRecord r = record_of(4, [](double) { return 100.0; });
    SettledMean m;
    m.known = true, m.value = -100, m.half_width = 0.1;
    widen_where_ended(r, m);
    EXPECT_EQ(m.half_width, 0.1) << "it was run to its duration";
    r.attributes[ended_by] = by_settling;
    widen_where_ended(r, m);
    EXPECT_EQ(m.half_width, 2);
    m.half_width = 5;
    widen_where_ended(r, m);
    EXPECT_EQ(m.half_width, 5);
}

// Rules that stop at a small scatter are biased. Of approaches as those that were recorded; docs/results/settled.md has
// thousands of series: 96 %, of 3 % of noise alone the worst.
TEST(SettledLoads, IntervalsOfEndedRunsHoldTheTruthInNinetyOfAHundredAtLeast) {
    int ends = 0, holds = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        auto n = noise(seed % 3 == 0 ? 0.02 : seed % 3 == 1 ? 0.06 : 0.2, 100 + seed);
        RunRecord r = record_of(6, [&](double t) { return 100 * (1 - std::exp(-t / 0.4)) + 1.5 * n(t); });
        r.table("forces").columns.resize(1);
        const double end = end_of(r);
        if (end == 0) continue;
        r.rewind(end * (1 + 1e-9));
        SettledRules rules;
        rules.from = 1.5, rules.flow_through = flow_through_time(r);
        SettledMean m = settled_mean(r.tables.at("forces").time, r.series("forces", "fz")->values, rules);
        r.attributes[ended_by] = by_settling;
        widen_where_ended(r, m);
        ++ends;
        holds += std::abs(m.value - 100) <= m.half_width;
    }
    EXPECT_GE(ends, 40);
    EXPECT_GE(holds, 0.9 * ends);
}

/// Times are sums of steps: a period that lacks less than a millionth of itself is whole, one that lacks more is not.
TEST(WholePeriods, AreCountedDespiteTheRoundingOfTimes) {
    EXPECT_EQ(whole_periods(1.5, 1.5 + 3 * 0.7 - 1e-9, 0.7), 3);
    EXPECT_EQ(whole_periods(1.5, 1.5 + 3 * 0.7 - 1e-5, 0.7), 2);
    EXPECT_EQ(whole_periods(1.5, 1.2, 0.7), 0) << "the end lies before the beginning";
}

}  // namespace settled_loads_test
}  // namespace tw
