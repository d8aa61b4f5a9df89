// What water does to solids in a tank: an event, judged by its impulse and its largest force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/compare.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace tank_loads_test {

/// A surge that presses for 0.2 s along x with half a sine of height `peak`, one row every `step`.
RunRecord surge(const char* method, const char* table, double peak, double step) {
    RunRecord r;
    r.attributes["method"] = method;
    r.numbers = {{"duration", 1}, {"dimensions", 3}};
    r.state = "finished";
    Table& t = r.table(table);
    for (double time = step; time < 1 + step / 2; time += step) {
        const std::size_t row = t.append(time);
        const double phase = (time - 0.4) / 0.2;
        t.set(row, "fx", "N", phase > 0 && phase < 1 ? -peak * std::sin(std::numbers::pi * phase) : 0);
        t.set(row, "fz", "N", 0.001 * peak);
    }
    return r;
}

const Quantity* find(const Comparison& c, const std::string& name) {
    const auto found = std::ranges::find(c.quantities, name, &Quantity::name);
    return found == c.quantities.end() ? nullptr : &*found;
}

TEST(TankLoads, OfASurgeImpulseAndLargestForceAreCompared) {
    const Comparison c = compare_records({surge("sph", "forces", 100, 0.5e-3), surge("fvm", "forces_total", 90, 4e-3)});
    const Quantity *impulse = find(c, "load_impulse_x"), *peak = find(c, "load_peak_x");
    ASSERT_TRUE(impulse && peak);
    EXPECT_NEAR(impulse->values[0].value, -100 * 0.2 * 2 / std::numbers::pi, 0.01);
    EXPECT_NEAR(impulse->values[1].value, -90 * 0.2 * 2 / std::numbers::pi, 0.01);
    EXPECT_NEAR(peak->values[0].value, -100, 0.2) << "of either sign";
    EXPECT_NEAR(peak->values[1].value, -90, 0.2);
    EXPECT_EQ(impulse->unit, "N s");
    EXPECT_EQ(impulse->label, "Impulse of the force along x by 1 s");
    EXPECT_TRUE(impulse->judged_in_grid_study);
    EXPECT_FALSE(find(c, "load_impulse_z")) << "a thousandth of the other";
    const Quantity* mean = find(c, "drag");
    ASSERT_TRUE(mean);
    EXPECT_FALSE(mean->judged) << "it does not settle";
}

TEST(TankLoads, TheAirsForceCountsWhereItStandsBesideAndAGapIsNoImpulse) {
    RunRecord with_air = surge("sph", "forces", 100, 1e-3), broken = surge("fvm", "forces_total", 90, 1e-3);
    Table& forces = with_air.table("forces");
    for (std::size_t i = 0; i < forces.time.size(); ++i) forces.set(i, "fx_air", "N", -10);
    broken.table("forces_total").column("fx", "N").values[500] = NAN;
    const Comparison c = compare_records({with_air, broken});
    const Quantity* impulse = find(c, "load_impulse_x");
    ASSERT_TRUE(impulse);
    EXPECT_NEAR(impulse->values[0].value, -100 * 0.2 * 2 / std::numbers::pi - 10 * 0.999, 0.03);
    EXPECT_FALSE(impulse->values[1].known);
    EXPECT_EQ(impulse->values[1].why_not, "its record has gaps");
}

TEST(TankLoads, WhatMovesOrStreamsHasOtherMeasures) {
    RunRecord floats = surge("sph", "forces", 100, 1e-3);
    floats.table(body_table("box")).append(0.1);
    EXPECT_FALSE(find(compare_records({floats, surge("fvm", "forces_total", 90, 1e-3)}), "load_impulse_x"));
    EXPECT_FALSE(find(compare_records({synthetic_run(synthetic_pair::sph), synthetic_run(synthetic_pair::fvm)}),
                      "load_impulse_x"));
}

}  // namespace tank_loads_test
}  // namespace tw
