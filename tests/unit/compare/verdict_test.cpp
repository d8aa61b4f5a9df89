#include <gtest/gtest.h>

#include <cmath>

#include "compare/verdict/judge.h"

namespace tw {
namespace verdict_test {

MeanValue known(double value, double half_width) {
    MeanValue m;
    m.known = true;
    m.value = value;
    m.half_width = half_width;
    return m;
}
Quantity judged(const std::vector<MeanValue>& values, double shared = 0) {
    Quantity q;
    q.values = values;
    std::vector<std::string> names{"a", "b", "c"};
    names.resize(values.size());
    judge(q, names, 0.05, shared, "the draft");
    return q;
}

TEST(Verdict, OfOneSizeThereIsADifferenceAndNoWordOfAgreement) {
    const Quantity q = judged({known(100, 2), known(102, 1.5)});
    EXPECT_EQ(q.verdict, Verdict::not_estimated);
    EXPECT_DOUBLE_EQ(q.difference, 2);
    EXPECT_DOUBLE_EQ(q.interval, 2.5);  // root of the sum of squares
    EXPECT_NEAR(q.per_cent, 100 * 2.0 / 101, 1e-12);
}

TEST(Verdict, FarOutsideTheScatterItIsApartWithItsSignAndNotMore) {
    const Quantity q = judged({known(110, 2), known(100, 1)});
    EXPECT_EQ(q.verdict, Verdict::not_estimated);
    EXPECT_EQ(q.difference, -10);
    EXPECT_LT(q.per_cent, 0);
    EXPECT_EQ(q.remark, "");
}

TEST(Verdict, ScatterAboveTheTargetNamesTheWidest) {
    const Quantity q = judged({known(100, 2), known(105, 12)});
    EXPECT_EQ(q.verdict, Verdict::not_estimated);
    EXPECT_NE(q.remark.find("this interval alone is wider than 5 %; widest: the mean of b"), std::string::npos)
        << q.remark;
}

TEST(Verdict, WhatBothShareWidensTheInterval) {
    EXPECT_DOUBLE_EQ(judged({known(100, 0), known(103, 4)}, 3).interval, 5);
    const Quantity q = judged({known(100, 1), known(103, 1)}, 30);
    EXPECT_NE(q.remark.find("the draft"), std::string::npos);
}

TEST(Verdict, TheRuleOfAGridStudy) {
    EXPECT_EQ(decide(2, 2.5, 0.05, 100), Verdict::agree);
    EXPECT_EQ(decide(-3, 2.5, 0.05, 100), Verdict::differ);
    EXPECT_EQ(decide(5, 12, 0.05, 100), Verdict::undecided);
    EXPECT_EQ(decide(0, 0, 0.05, 100), Verdict::agree);
    // An interval that wide is known too roughly to judge by, whatever lies outside it; one that was asked for is not.
    EXPECT_EQ(decide(5, 29.9, 0.05, 100), Verdict::undecided);
    EXPECT_EQ(decide(5, 30.1, 0.05, 100), Verdict::no_answer);
    EXPECT_EQ(decide(80, 40, 0.05, 100), Verdict::no_answer);
    EXPECT_EQ(decide(80, 29, 0.05, 100), Verdict::differ);
    EXPECT_EQ(decide(5, 38, 0.4, 100), Verdict::agree);
    // A difference that is shown, and shown to be within the target.
    EXPECT_EQ(decide(-0.5, 0.3, 0.05, 100), Verdict::agree);
    EXPECT_EQ(decide(4.8, 0.3, 0.05, 100), Verdict::differ);
    EXPECT_EQ(holds(-0.5, 0.3, 0.05, 100), Verdict::differ) << "a measurement outside the interval is outside";
}

TEST(Verdict, ATooShortRecordIsUndecidedAMissingValueNotComparable) {
    MeanValue brief;
    brief.why_not = "record too short";
    brief.seconds_needed = 0.8;
    EXPECT_EQ(judged({known(100, 1), brief}).verdict, Verdict::undecided);
    MeanValue missing;
    missing.why_not = "this method does not give it";
    const Quantity q = judged({known(100, 1), missing});
    EXPECT_EQ(q.verdict, Verdict::not_comparable);
    EXPECT_NE(q.remark.find("b: this method"), std::string::npos);
    EXPECT_TRUE(std::isnan(q.difference));
    EXPECT_EQ(judged({known(100, 1)}).verdict, Verdict::not_comparable);
}

TEST(Verdict, OfThreeEveryPairIsJudgedAndTheOneFarthestApartInItsIntervalStandsForAll) {
    const Quantity q = judged({known(100, 3), known(101, 4), known(110, 0)}, 12);
    ASSERT_EQ(q.pairs.size(), 3u);
    const double differences[] = {1, 10, 9}, intervals[] = {13, std::hypot(3, 12), std::hypot(4, 12)};
    const std::size_t places[][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(q.pairs[k].a, places[k][0]);
        EXPECT_EQ(q.pairs[k].b, places[k][1]);
        EXPECT_DOUBLE_EQ(q.pairs[k].difference, differences[k]);
        EXPECT_DOUBLE_EQ(q.pairs[k].interval, intervals[k]);
        EXPECT_EQ(q.pairs[k].verdict, Verdict::not_estimated);
    }
    EXPECT_NEAR(q.pairs[2].per_cent, 100 * 9 / 105.5, 1e-12);
    EXPECT_EQ(q.verdict, Verdict::not_estimated);
    EXPECT_EQ(q.difference, 10);
    EXPECT_EQ(q.a, 0u);
    EXPECT_EQ(q.b, 2u);
    EXPECT_EQ(q.differences().size(), 3u);
    EXPECT_EQ(judged({known(100, 1), known(101, 1)}).differences().size(), 1u);
}

TEST(Verdict, OfThreeAMissingValueLeavesTheOtherPair) {
    MeanValue missing;
    missing.why_not = "this method does not give it";
    const Quantity q = judged({known(100, 1), missing, known(110, 1)});
    EXPECT_EQ(q.difference, 10);
    EXPECT_EQ(q.verdict, Verdict::not_estimated);
    for (const std::size_t k : {0u, 2u}) {
        EXPECT_EQ(q.pairs[k].verdict, Verdict::not_comparable);
        EXPECT_NE(q.pairs[k].remark.find("b: this method"), std::string::npos);
    }
    EXPECT_EQ(judged({missing, missing, known(1, 1)}).verdict, Verdict::not_comparable);
}

TEST(Verdict, NamesForProgramsStay) {
    EXPECT_EQ(to_string(Verdict::agree), "agree");
    EXPECT_EQ(to_string(Verdict::differ), "differ");
    EXPECT_EQ(to_string(Verdict::undecided), "undecided");
    EXPECT_EQ(to_string(Verdict::no_answer), "no_answer_yet");
    EXPECT_EQ(to_string(Verdict::not_comparable), "not_comparable");
    EXPECT_EQ(to_string(Verdict::not_converged), "not_converged");
    EXPECT_EQ(to_string(Verdict::not_estimated), "discretisation error not estimated");
}

}  // namespace verdict_test
}  // namespace tw
