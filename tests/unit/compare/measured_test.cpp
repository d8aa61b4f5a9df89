// Measured values that a scene gives: a reference in the units of the report, and who misses it.
#include <gtest/gtest.h>

#include <algorithm>

#include "compare/compare.h"
#include "compare/report/first_screen.h"
#include "record/measured_value.h"
#include "synthetic_pair.h"

namespace tw {
namespace measured_reference_test {

Comparison beside(const MeasuredValue& m) {
    std::vector<RunRecord> runs = {synthetic_run({.lift = 2400}), synthetic_run({.method = "fvm", .lift = 3131})};
    for (RunRecord& r : runs) note_measured(r, m);
    return compare_records(runs);
}
const Reference* of_measurement(const Comparison& c) {
    const auto found = std::ranges::find_if(
        c.references, [](const Reference& r) { return r.source.find("Tank 3") != std::string::npos; });
    return found == c.references.end() ? nullptr : &*found;
}

TEST(MeasuredReference, HasTheUnitOfItsQuantityAndSaysWhoMissesIt) {
    const Comparison c = beside({"lift", "kN", "Tank 3", 2390, 30});
    const Reference* r = of_measurement(c);
    ASSERT_TRUE(r);
    EXPECT_EQ(r->unit, "N");
    EXPECT_NEAR(r->value, 2390, 1e-9);
    EXPECT_NEAR(r->half_width, 30, 1e-9);
    const std::vector<Doubt> doubts = doubts_of(c);
    EXPECT_TRUE(std::ranges::any_of(doubts, [](const Doubt& d) {
        return d.text.starts_with("interFoam lies outside the measured value (Tank 3): lift 31 % above");
    }));
}

// Savitsky's formula gives 2334 N.
TEST(MeasuredReference, DecidesWhetherItIsGraveThatAFormulaIsMissed) {
    const auto first = [](const std::vector<RunRecord>& runs) { return doubts_of(compare_records(runs)).front(); };
    std::vector<RunRecord> runs = {synthetic_run({.lift = 3000}), synthetic_run({.method = "fvm", .lift = 3131})};
    EXPECT_TRUE(first(runs).grave);
    for (RunRecord& r : runs) note_measured(r, {"lift", "N", "Tank 3", 2800, 400});
    const Doubt doubt = first(runs);
    EXPECT_FALSE(doubt.grave) << doubt.text;
    EXPECT_NE(doubt.text.find("lift 29 to 35 % above (measured: 20 % above)"), std::string::npos) << doubt.text;
}

TEST(MeasuredReference, OfNoQuantityOrInAnotherUnitIsSaid) {
    for (const MeasuredValue& wrong : {MeasuredValue{"lft", "N", "Tank 3", 2390, 0},
                                       {"lift", "m", "Tank 3", 2390, 0},
                                       {"lift", "<b>", "Tank 3", 2390, 0}}) {
        const Comparison c = beside(wrong);
        EXPECT_FALSE(of_measurement(c));
        EXPECT_TRUE(std::ranges::any_of(c.banners, [&](const std::string& b) {
            return b.find("measured value of " + wrong.quantity) != std::string::npos;
        }));
    }
}

}  // namespace measured_reference_test
}  // namespace tw
