#include <gtest/gtest.h>

#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/verdict/judge.h"

namespace tw {
namespace sentence_test {

Statement lift() {
    Statement s{.label = "Lift", .unit = "N"};
    s.methods = {"sph", "fvm"}, s.values = {3100, 3000}, s.size = 3050;
    s.interval = 0.09 * 3050, s.discretisation = 0.09 * 3050, s.statistics = 3, s.choices = 0;
    s.verdict = Verdict::undecided;
    return s;
}

TEST(Sentence, CanBeForwardedAsItIs) {
    Statement s = lift();
    s.seconds_to_target = 2400;
    EXPECT_EQ(
        sentence_of(s),
        "Lift: SPH 3.3 % above interFoam, discretisation error ±9.0 %: no difference shown; 40 min of further runs "
        "would bring it to ±5.0 %.");
    s.seconds_to_target = 110 * 86400.0;  // of a row that is nowhere near it
    EXPECT_EQ(sentence_of(s), "Lift: SPH 3.3 % above interFoam, discretisation error ±9.0 %: no difference shown.")
        << "nobody waits for that";
    s.seconds_to_target = nan;  // not known: nothing is promised
    EXPECT_EQ(sentence_of(s), "Lift: SPH 3.3 % above interFoam, discretisation error ±9.0 %: no difference shown.");
    s.verdict = Verdict::differ, s.interval = s.discretisation = 0.02 * 3050;
    EXPECT_EQ(sentence_of(s),
              "Lift: SPH 3.3 % above interFoam, discretisation error ±2.0 %: they differ, perhaps by less than 5.0 %.");
    s.values = {3200, 3000}, s.size = 3100;
    EXPECT_TRUE(sentence_of(s).ends_with("±2.0 %: they differ.")) << sentence_of(s);
    s.values = {3100, 3000}, s.size = 3050;
    s.verdict = Verdict::agree, s.interval = s.discretisation = 0.04 * 3050;
    EXPECT_EQ(sentence_of(s), "Lift: SPH 3.3 % above interFoam, discretisation error ±4.0 %: they agree within 5.0 %.");
}

// Beside a headline that has the quantity and the verdict.
TEST(Sentence, AsAFindingItRepeatsNeitherQuantityNorVerdict) {
    Statement s = lift();
    s.seconds_to_target = 2400;
    EXPECT_EQ(
        finding_of(s),
        "SPH 3.3 % above interFoam, discretisation error ±9.0 %; 40 min of further runs would bring it to ±5.0 %.");
    s.verdict = Verdict::agree, s.interval = s.discretisation = 0.04 * 3050;
    EXPECT_EQ(finding_of(s), "SPH 3.3 % above interFoam, discretisation error ±4.0 %.");
    s.verdict = Verdict::not_converged, s.interval = nan, s.why = "SPH: the changes do not decrease";
    EXPECT_EQ(finding_of(s), "SPH 3.3 % above interFoam, without an interval; SPH: the changes do not decrease.");
}

TEST(Sentence, OfAnIntervalBeyondThirtyPerCentThereIsNoAnswerYet) {
    Statement s = lift();
    s.values = {4000, 2000}, s.size = 3000, s.interval = s.discretisation = 0.93 * 3000;
    s.verdict = decide(-2000, s.interval, s.target, s.size);
    EXPECT_EQ(sentence_of(s), "Lift: SPH 67 % above interFoam, discretisation error ±93 %: no answer yet.");
    s.methods = {"sph"}, s.values = {3000};
    EXPECT_EQ(sentence_of(s), "Lift: no answer yet: 3000 ± 2790 N by SPH, discretisation error ±93 %.");
}

TEST(Sentence, NamesTheSharesWhereTheResolutionIsNotAll) {
    Statement s = lift();
    s.discretisation = 0.06 * 3050, s.choices = 0.067 * 3050;
    EXPECT_NE(sentence_of(s).find("uncertainty ±9.0 % (discretisation error ±6.0 %, other choices ±6.7 %)"),
              std::string::npos)
        << sentence_of(s);
}

TEST(Sentence, NoPerCentIsWithoutAnIntervalOrTheWordsThatItHasNone) {
    Statement s = lift();
    s.verdict = Verdict::not_converged, s.interval = nan, s.why = "SPH: the changes do not decrease";
    EXPECT_EQ(sentence_of(s),
              "Lift: SPH 3.3 % above interFoam, without an interval: not converged, SPH: the changes do not decrease.");
    s.methods = {"sph"}, s.values = {3100}, s.verdict = Verdict::not_comparable;
    EXPECT_EQ(sentence_of(s), "Lift: 3100 N by SPH, without an interval: SPH: the changes do not decrease.");
    EXPECT_EQ(per_cent_text(3.14, 9.04), "+3.1 ± 9.0 %");
    EXPECT_EQ(per_cent_text(-31.4, 9.04), "−31 ± 9 %");
    EXPECT_EQ(per_cent_text(3.14, std::nan("")), "+3.1 %, no interval");
    EXPECT_EQ(per_cent_text(3.14, 0.02), "+3.1 ± 0.02 %");
}

TEST(Sentence, OfZerosHasItsIntervalInTheirUnit) {
    Statement s = lift();
    s.label = "Splash height", s.unit = "m", s.values = {0, 0}, s.size = 0;
    s.interval = s.statistics = 0.14, s.discretisation = 0;
    EXPECT_EQ(sentence_of(s),
              "Splash height: SPH and interFoam are both 0, scatter of the mean ±0.14 m: no difference shown.");
    s.values = {0.15, 0}, s.size = 0.075, s.verdict = Verdict::differ, s.interval = s.statistics = 0.03;
    EXPECT_EQ(sentence_of(s), "Splash height: SPH 0.150 m, interFoam 0, scatter of the mean ±0.03 m: they differ.");
}

/// Per cent of the mean of something and nearly nothing are 200, whatever the nothing is.
TEST(Sentence, OfAValueThatIsNothingBesideTheOtherHasBothInTheirUnit) {
    Statement s = lift();
    s.label = "Suction on hull", s.values = {0.3, 61}, s.size = 30.65, s.interval = s.discretisation = 9;
    s.statistics = 0, s.verdict = Verdict::differ;
    EXPECT_EQ(sentence_of(s), "Suction on hull: interFoam 61.0 N, SPH 0.3 N, discretisation error ±9 N: they differ.");
    s.values = {3.5, 61}, s.size = 32.25;  // no value is 188 % below another
    EXPECT_TRUE(sentence_of(s).starts_with("Suction on hull: interFoam 61.0 N, SPH 3.5 N, ")) << sentence_of(s);
    s.values = {21, 61}, s.size = 41;
    EXPECT_TRUE(sentence_of(s).starts_with("Suction on hull: SPH 98 % below interFoam, ")) << sentence_of(s);
    EXPECT_EQ(difference_text(-200, 30), "too far apart for per cent");
    EXPECT_EQ(difference_text(-31.4, 9.04), "−31 ± 9 %");
}

TEST(Sentence, NegativeValuesAreComparedInMagnitude) {
    Statement s = lift();
    s.label = "Trim moment", s.values = {-2652, -2509}, s.size = 2580;
    EXPECT_TRUE(sentence_of(s).starts_with("Trim moment: SPH 5.5 % above interFoam in magnitude, ")) << sentence_of(s);
    s.values = {-100, 50}, s.size = 75;
    EXPECT_TRUE(sentence_of(s).starts_with("Trim moment: SPH −100 N, interFoam 50 N, ")) << sentence_of(s);
}

/// What per cent of a scale that is larger than both values mean, no reader can know.
TEST(Sentence, OfValuesBelowTheirScaleHasThemAndTheTargetInTheirUnit) {
    Statement s = lift();
    s.label = "Trim moment", s.unit = "N m", s.values = {30, 24}, s.size = 200, s.seconds_to_target = 60;
    s.interval = s.discretisation = 20;
    EXPECT_EQ(sentence_of(s),
              "Trim moment: SPH 30 N m, interFoam 24 N m, discretisation error ±20 N m: no difference shown; 60 s of "
              "further runs would bring it to ±10 N m.");
    EXPECT_EQ(difference_text(-3, 10, of_scale(200, 30, 24, "N m")), "−3 ± 10 % of 200 N m");
    EXPECT_EQ(of_scale(27, 30, 24, "N m"), "");
}

TEST(Sentence, WithoutValuesItSaysWhy) {
    Statement s{.label = "Drag", .unit = "N"};
    s.why = "SPH: no size has a mean";
    EXPECT_EQ(sentence_of(s), "Drag: not comparable: SPH: no size has a mean.");
}

}  // namespace sentence_test
}  // namespace tw
