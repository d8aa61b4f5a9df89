// Cells of the quick stability map: the usual numbers are stable at every speed, and what is not sound is said to be
// so.
#include "stability/map.h"

#include <gtest/gtest.h>

namespace tw {
namespace map_test {

StabilityJudgement judged(HardCaseKind kind, const std::function<void(HardCase&)>& change) {
    for (const StabilityMap& map : stability_maps(true))
        if (map.base.kind == kind) {
            HardCase c = map.base;
            change(c);
            const StabilityJudgement j = judge_stability(c, run_hard_case(c));
            std::cout << describe(c) << ": " << to_string(j.stability) << " " << j.label << " " << j.reason << "\n";
            return j;
        }
    throw std::logic_error("no map of this kind");
}
bool says(const StabilityJudgement& j, const std::string& words) { return j.reason.find(words) != std::string::npos; }

/// The quick stream's compression is single particles at the plate's edges, 4 to 5 %, where 5 % is the limit: rounding
/// may carry it over.
void expect_no_more_than_an_edge(const StabilityJudgement& stream) {
    EXPECT_NE(stream.stability, Stability::failed);
    EXPECT_FALSE(says(stream, "Mach number")) << stream.reason;
}

TEST(StabilityMap, UsualNumbersAreStableAtEverySpeed) {
    for (const double speed : {8, 30, 80}) {
        for (const double deadrise : {0, 2, 30})
            EXPECT_EQ(judged(HardCaseKind::impact, [&](HardCase& c) { c.speed = speed, c.deadrise_deg = deadrise; })
                          .stability,
                      Stability::stable);
        expect_no_more_than_an_edge(judged(HardCaseKind::stream, [&](HardCase& c) { c.speed = speed; }));
    }
}

TEST(StabilityMap, UsualNumbersAreStableUpToTheStatedCourantNumber) {
    const auto limit = [](HardCase& c) { c.cfl = stated_courant_limit; };
    for (const HardCaseKind kind : {HardCaseKind::impact, HardCaseKind::tank})
        EXPECT_EQ(judged(kind, limit).stability, Stability::stable);
    expect_no_more_than_an_edge(judged(HardCaseKind::stream, limit));
}

// An edge between two sizes through the jets of an impact, behind a plate and across still water.
TEST(StabilityMap, TwoSizesOfParticlesAreAsStableAsOne) {
    const auto zone = [](HardCase& c) { c.zone = 8; };
    for (const double deadrise : {2, 30})
        EXPECT_EQ(judged(HardCaseKind::impact, [&](HardCase& c) { c.zone = 8, c.deadrise_deg = deadrise; }).stability,
                  Stability::stable);
    expect_no_more_than_an_edge(judged(HardCaseKind::stream, zone));
    EXPECT_NE(judged(HardCaseKind::tank, zone).stability, Stability::failed);
}

TEST(StabilityMap, BeyondItNothingPassesAsStable) {
    EXPECT_EQ(judged(HardCaseKind::impact, [](HardCase& c) { c.cfl = 1.8; }).stability, Stability::failed);
    EXPECT_EQ(judged(HardCaseKind::tank, [](HardCase& c) { c.cfl = 1.8; }).stability, Stability::failed);
    EXPECT_NE(judged(HardCaseKind::stream, [](HardCase& c) { c.cfl = 1.8; }).stability, Stability::stable);
}

TEST(StabilityMap, ASoundSpeedThatIsTooLowIsStoppedOrSaid) {
    const auto low = [](HardCase& c) { c.c0_over_speed = 4; };
    const StabilityJudgement impact = judged(HardCaseKind::impact, low), stream = judged(HardCaseKind::stream, low);
    EXPECT_EQ(impact.stability, Stability::failed);
    EXPECT_TRUE(says(impact, "sound speed"));
    EXPECT_EQ(stream.stability, Stability::warned);
    EXPECT_TRUE(says(stream, "c0 too low: Mach number"));
    EXPECT_TRUE(
        says(judged(HardCaseKind::impact, [](HardCase& c) { c.c0_over_speed = 10; }), "c0 too low: Mach number"));
}

}  // namespace map_test
}  // namespace tw
