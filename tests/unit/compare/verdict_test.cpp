#include <gtest/gtest.h>

#include <cmath>

#include "compare/verdict/judge.h"

namespace tw {
namespace {

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

TEST(Verdict, InsideANarrowIntervalAgrees) {
    const Quantity q = judged({known(100, 2), known(102, 1.5)});
    EXPECT_EQ(q.verdict, Verdict::agree);
    EXPECT_DOUBLE_EQ(q.difference, 2);
    EXPECT_DOUBLE_EQ(q.interval, 2.5);  // root of the sum of squares
    EXPECT_NEAR(q.per_cent, 100 * 2.0 / 101, 1e-12);
}

TEST(Verdict, OutsideTheIntervalDiffersWithItsSign) {
    const Quantity q = judged({known(110, 2), known(100, 1)});
    EXPECT_EQ(q.verdict, Verdict::differ);
    EXPECT_EQ(q.difference, -10);
    EXPECT_LT(q.per_cent, 0);
    EXPECT_EQ(q.remark, "");
    EXPECT_NE(judged({known(103, 1), known(100, 1)}).remark.find("within the target"), std::string::npos);
}

TEST(Verdict, AWideIntervalLeavesItUndecidedAndNamesTheWidest) {
    const Quantity q = judged({known(100, 2), known(105, 12)});
    EXPECT_EQ(q.verdict, Verdict::undecided);
    EXPECT_NE(q.remark.find("interval of b"), std::string::npos);
}

TEST(Verdict, WhatBothShareWidensTheInterval) {
    EXPECT_EQ(judged({known(100, 1), known(103, 1)}).verdict, Verdict::differ);
    EXPECT_EQ(judged({known(100, 1), known(103, 1)}, 3).verdict, Verdict::agree);
    const Quantity q = judged({known(100, 1), known(103, 1)}, 30);
    EXPECT_EQ(q.verdict, Verdict::undecided);
    EXPECT_NE(q.remark.find("the draft"), std::string::npos);
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

TEST(Verdict, ExactlyEqualValuesAgreeEvenWithoutAnInterval) {
    EXPECT_EQ(judged({known(100, 0), known(100, 0)}).verdict, Verdict::agree);
    EXPECT_EQ(judged({known(100, 0), known(100.001, 0)}).verdict, Verdict::differ);
}

TEST(Verdict, OfThreeThePairFarthestApartInItsIntervalIsJudged) {
    const Quantity q = judged({known(100, 1), known(101, 1), known(110, 1)});
    EXPECT_EQ(q.verdict, Verdict::differ);
    EXPECT_EQ(q.difference, 10);
    EXPECT_NE(q.remark.find("a and c"), std::string::npos);
}

TEST(Verdict, NamesForProgramsStay) {
    EXPECT_EQ(to_string(Verdict::agree), "agree");
    EXPECT_EQ(to_string(Verdict::differ), "differ");
    EXPECT_EQ(to_string(Verdict::undecided), "undecided");
    EXPECT_EQ(to_string(Verdict::not_comparable), "not_comparable");
}

}  // namespace
}  // namespace tw
