#include "compare/verdict/left_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace left_out_test {

EffectChoice effect(const std::string& name, bool on, const std::string& influence) {
    return {.name = name, .on = on, .forced = false, .reason = {}, .influence = influence};
}

/// A planing hull's plan.
RunRecord run(bool friction_line) {
    RunRecord r;
    r.effects = {effect("viscosity", false, "drag: about 120 N of friction (ITTC 1957), left out; lift: below 1 %"),
                 effect("no_slip", false, "drag: all of the friction; lift: below 1 %"),
                 effect("friction", friction_line, "drag: about 120 N, left out; lift: none"),
                 effect("turbulence", false, "drag: 4 % of the pressure drag (measured); lift: 0.7 % (measured)"),
                 effect("air", false, "drag: 10 % (dry topsides); lift: 3 to 5 % (the same); splash: drops are slowed"),
                 effect("surface_tension", false, "drag: 4.9e-05 %; lift: 4.9e-05 %; splash: holds small drops"),
                 effect("gravity", true, "drag: 35 %; lift: 35 %"),
                 effect("ventilation", false, "drag: 60 % and more on round bodies; lift: the same"),
                 effect("tension_control", false, "drag: not measured; lift: not measured")};
    return r;
}

Quantity quantity(const std::string& name, double value, double interval) {
    Quantity q;
    q.name = name, q.label = name, q.unit = "N";
    MeanValue m;
    m.known = true, m.value = value, m.half_width = m.uncertainty = interval;
    q.values = {m};
    return q;
}

std::string names(const std::vector<LeftOut>& all) {
    std::string text;
    for (const LeftOut& l : all) text += l.name + (std::isfinite(l.bound) ? "" : "?") + " ";
    return text;
}

TEST(LeftOut, IsWhatIsOffAndMattersToTheQuantity) {
    const auto of = [](const std::string& name, bool friction_line) {
        const Quantity q = quantity(name, 400, 30);
        return names(left_out_of(q, q.values[0], run(friction_line)));
    };
    EXPECT_EQ(of("total_drag", true), "turbulence air ventilation? ");
    EXPECT_EQ(of("total_drag", false), "viscosity turbulence air ventilation? ");
    EXPECT_EQ(of("lift", true), "turbulence air ventilation? ");
    EXPECT_EQ(of("splash_sheet_height", true), "air? surface tension? ");
    EXPECT_EQ(of("wetted_length", true), "");
    EXPECT_EQ(names(left_out_of(quantity("lift", 400, 30), MeanValue(), run(true))), "") << "of no value";
    RunRecord section = run(true);
    section.effects.clear();
    section.numbers["dimensions"] = 2;
    const Quantity q = quantity("lift", 400, 30);
    EXPECT_EQ(names(left_out_of(q, q.values[0], section)), "the third dimension? ");
}

TEST(LeftOut, WithABoundIsInTheOuterInterval) {
    const Quantity drag = quantity("total_drag", 400, 30), lift = quantity("lift", -1000, 30);
    EXPECT_NEAR(outer_half_width(drag, drag.values[0], run(true)), std::sqrt(30 * 30 + 16 * 16 + 40 * 40), 1e-9);
    EXPECT_NEAR(outer_half_width(drag, drag.values[0], run(false)), std::sqrt(30 * 30 + 120 * 120 + 16 * 16 + 40 * 40),
                1e-9);
    EXPECT_NEAR(outer_half_width(lift, lift.values[0], run(true)), std::sqrt(30 * 30 + 7 * 7 + 50 * 50), 1e-9);
    Quantity none = drag;
    none.values[0].uncertainty = nan, none.values[0].no_uncertainty = "not converged";
    EXPECT_TRUE(std::isnan(outer_half_width(none, none.values[0], run(true))));
    const RunRecord all_solved;
    EXPECT_TRUE(std::isnan(outer_half_width(drag, drag.values[0], all_solved)));
}

TEST(LeftOut, StandsInOneLineAndInATableOfTheTerminal) {
    RunRecord a = synthetic_run({.method = "sph", .frames = false}),
              b = synthetic_run({.method = "fvm", .seed = 2, .frames = false});
    EXPECT_EQ(left_out_text(compare_records({a, b})), "");
    a.effects = b.effects = run(true).effects;
    const Comparison c = compare_records({a, b});
    const std::string line = left_out_text(c), text = summary_text(c);
    EXPECT_NE(line.find("turbulence (drag 4 % of the pressure drag, lift 0.7 %)"), std::string::npos) << line;
    EXPECT_NE(line.find("air (drag 10 %, lift 3 to 5 %)"), std::string::npos) << line;
    EXPECT_NE(text.find("Not in these intervals"), std::string::npos) << text;
    EXPECT_NE(text.find("turbulence (0.7 %), air (3 to 5 %), ventilation (the same)"), std::string::npos) << text;
}

}  // namespace left_out_test
}  // namespace tw
